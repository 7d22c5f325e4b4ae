// SPDX-License-Identifier: GPL-3.0-or-later
// Holds the current work. A work is immutable: each change makes the next work, and listeners compare the two.
import { Signal } from './signal.js';

/** @typedef {import('./work.js').Work} Work */

export class WorkStore {
  /** @param {Work} work */
  constructor(work) {
    this.work_ = frozen(work);
    /** Announces each change with the work after and before it. A listener must not change the work. @type {Signal<[Work, Work]>} */
    this.changed = new Signal();
    /**
     * Announces a complete edit, while `changed` announces every typed letter. Its value is the edited field, if any.
     * @type {Signal<[string | undefined]>}
     */
    this.applied = new Signal();
    this.isEmitting_ = false;
  }

  get work() {
    return this.work_;
  }

  /**
   * Replaces the work by one with these changes. An update without a difference is not announced.
   * @param {Partial<Work> | ((work: Work) => Partial<Work>)} change
   */
  update(change) {
    if (this.isEmitting_) throw new Error('a listener of the work must not change it');
    const before = this.work_;
    const changed = typeof change === 'function' ? change(before) : change;
    const keys = /** @type {(keyof Work)[]} */ (Object.keys(changed));
    if (keys.every((key) => changed[key] === before[key])) return;
    this.work_ = frozen({ ...before, ...changed });
    this.isEmitting_ = true;
    try {
      this.changed.emit(this.work_, before);
    } finally {
      this.isEmitting_ = false;
    }
  }
}

/** @param {Work} work */
function frozen(work) {
  Object.freeze(work.settings);
  return Object.freeze(work);
}
