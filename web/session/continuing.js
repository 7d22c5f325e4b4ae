// SPDX-License-Identifier: GPL-3.0-or-later
// Offers the last visit's work and stores the current work.
import { text } from '../i18n/catalogue.js';

/** @typedef {import('../storage/last_work.js').Work} Work */

const kNotice = 'continue';

export class Continuing {
  /**
   * @param {object} options
   * @param {import('../storage/last_work.js').LastWork} options.last
   * @param {import('../ui/notices.js').Notices} options.notices
   * @param {() => Work | undefined} options.current          undefined while there is no model
   * @param {(work: Work) => Promise<void>} options.onContinue
   */
  constructor({ last, notices, current, onContinue }) {
    this.last_ = last;
    this.notices_ = notices;
    this.current_ = current;
    this.onContinue_ = onContinue;
    this.watching_ = false;
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') void this.last_.flush(); // the page may never become visible again
    });
  }

  /**
   * Starts storing changes to the work with which the page opened.
   * @param {boolean} offer  offer the last visit's work
   */
  async begin(offer) {
    this.last_.openedWith(this.current_()); // before the first await: the work may change meanwhile
    this.watching_ = true;
    const work = offer ? await this.last_.recall() : undefined;
    if (!work) return;
    this.notices_.show(kNotice, text('autosave.continueWith', { name: work.fileName }), [
      { label: text('autosave.discard'), run: () => void this.last_.discard() },
      { label: text('autosave.continue'), run: () => void this.onContinue_(work), primary: true },
    ]);
  }

  /** Stores the work if it has changed. */
  note() {
    const work = this.current_();
    if (this.watching_ && work) this.last_.note(work);
  }
}
