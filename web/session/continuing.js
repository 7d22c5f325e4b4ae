// SPDX-License-Identifier: GPL-3.0-or-later
// Offers the last visit's work and stores the current work.
import { text } from '../i18n/catalogue.js';
import { storedWork } from './work.js';

/** @typedef {import('../storage/last_work.js').Work} Work */

const kNotice = 'continue';

export class Continuing {
  /**
   * @param {object} options
   * @param {import('../storage/last_work.js').LastWork} options.last
   * @param {import('../ui/notices.js').Notices} options.notices
   * @param {import('./work_store.js').WorkStore} options.store
   * @param {(work: Work) => Promise<void>} options.onContinue
   */
  constructor({ last, notices, store, onContinue }) {
    this.last_ = last;
    this.notices_ = notices;
    this.store_ = store;
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
    this.last_.openedWith(storedWork(this.store_.work)); // before the first await: the work may change meanwhile
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
    const work = storedWork(this.store_.work);
    if (this.watching_ && work) this.last_.note(work);
  }
}
