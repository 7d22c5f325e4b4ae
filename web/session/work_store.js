// SPDX-License-Identifier: GPL-3.0-or-later
// Holds the current work. It never changes a work: each change makes the next one, and listeners compare the two.

/** @typedef {import('./work.js').Work} Work */
/** @typedef {(work: Work, before: Work) => void} Listener */

export class WorkStore {
  /** @param {Work} work */
  constructor(work) {
    this.work_ = frozen(work);
    /** @type {Listener[]} */ this.listeners_ = [];
    this.isTelling_ = false;
  }

  get work() {
    return this.work_;
  }

  /**
   * Replaces the work by one with these changes. Tells nobody if nothing is different.
   * @param {Partial<Work> | ((work: Work) => Partial<Work>)} change
   */
  update(change) {
    if (this.isTelling_) throw new Error('a listener of the work must not change it');
    const before = this.work_;
    const changed = typeof change === 'function' ? change(before) : change;
    const keys = /** @type {(keyof Work)[]} */ (Object.keys(changed));
    if (keys.every((key) => changed[key] === before[key])) return;
    this.work_ = frozen({ ...before, ...changed });
    this.isTelling_ = true;
    try {
      for (const listener of this.listeners_) listener(this.work_, before);
    } finally {
      this.isTelling_ = false;
    }
  }

  /** Calls a listener after each change. It must not change the work itself. @param {Listener} listener */
  onChange(listener) {
    this.listeners_.push(listener);
  }
}

/** @param {Work} work */
function frozen(work) {
  Object.freeze(work.values);
  return Object.freeze(work);
}
