// SPDX-License-Identifier: GPL-3.0-or-later
// Offers the last visit's work and stores the current work.
import { text } from '../i18n/catalogue.js';
import { modelName } from '../i18n/model_name.js';
import { storedWork } from './work.js';

const kNotice = 'continue';

export class Autosave {
  /**
   * @param {object} options
   * @param {import('../storage/last_work.js').LastWork} options.last
   * @param {import('../ui/notices.js').Notices} options.notices
   * @param {import('./work_store.js').WorkStore} options.store
   * @param {Pick<import('./work_editor.js').WorkEditor, 'continueWith'>} options.editor
   * @param {(action: () => Promise<unknown>) => Promise<void>} options.guard
   */
  constructor({ last, notices, store, editor, guard }) {
    this.last_ = last;
    this.notices_ = notices;
    this.store_ = store;
    this.editor_ = editor;
    this.guard_ = guard;
    this.watching_ = false;
    store.changed.on(() => this.save()); // not only complete edits: the page may close while the user types
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') void this.last_.flush(); // the page may never become visible again
    });
  }

  /**
   * Starts storing changes to the work with which the page opened.
   * @param {'always' | 'same-address' | 'never'} offer  whether to offer the last visit's work: an address that asks for
   *   something takes precedence, unless the work was done at that address
   */
  async begin(offer) {
    this.last_.openedWith(this.stored_()); // before the first await: the work may change meanwhile
    this.watching_ = true;
    const work = offer === 'never' ? undefined : await this.last_.recall();
    if (!work || (offer === 'same-address' && work.address !== location.search)) return;
    this.notices_.show(kNotice, text('autosave.continueWith', { name: modelName(work) }), [
      { label: text('autosave.discard'), run: () => void this.last_.discard() },
      {
        label: text('autosave.continue'),
        run: () => void this.guard_(() => this.editor_.continueWith(work)),
        primary: true,
      },
    ]);
  }

  /** Stores the work if it has changed. */
  save() {
    const work = this.watching_ && this.stored_();
    if (work) this.last_.save(work);
  }

  stored_() {
    const work = storedWork(this.store_.work);
    return work && { ...work, address: location.search };
  }
}
