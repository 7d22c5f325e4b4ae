// SPDX-License-Identifier: GPL-3.0-or-later
// What has become of each row of a batch: a byte a row, and words for those that failed.

/** @typedef {'waiting' | 'running' | 'done' | 'failed'} RowState */

/** @type {readonly RowState[]} */
const kStates = ['waiting', 'running', 'done', 'failed'];

export class RowStates {
  /** @param {number} count */
  constructor(count) {
    this.states_ = new Uint8Array(count);
    /** @type {Map<number, string>} */ this.reasons_ = new Map();
    /** @type {Record<RowState, number>} */ this.counts = { waiting: count, running: 0, done: 0, failed: 0 };
  }

  get size() {
    return this.states_.length;
  }

  /** Rows that nothing is to be done for any more. */
  get finished() {
    return this.counts.done + this.counts.failed;
  }

  /** @param {number} index @returns {RowState} */
  of(index) {
    return kStates[this.states_[index]];
  }

  /** Why it failed; '' if it did not. @param {number} index */
  reasonOf(index) {
    return this.reasons_.get(index) ?? '';
  }

  /** @param {number} index @param {RowState} state @param {string} [reason] */
  set(index, state, reason = '') {
    if (!(index >= 0 && index < this.size)) return;
    this.counts[this.of(index)] -= 1;
    this.counts[state] += 1;
    this.states_[index] = kStates.indexOf(state);
    if (state === 'failed') this.reasons_.set(index, reason);
    else this.reasons_.delete(index);
  }

  /** The first row from an index on that is in this state; none: -1. @param {RowState} state @param {number} [from] */
  next(state, from = 0) {
    return this.states_.indexOf(kStates.indexOf(state), from);
  }

  /** Indices of the rows in this state, or of all; `count` of them behind the first `skipped`. @param {RowState | 'all'} state @param {number} skipped @param {number} count */
  page(state, skipped, count) {
    /** @type {number[]} */ const indices = [];
    if (state === 'all') {
      for (let index = skipped; index < Math.min(this.size, skipped + count); index += 1) indices.push(index);
      return indices;
    }
    let passed = 0;
    for (let index = this.next(state); index >= 0 && indices.length < count; index = this.next(state, index + 1)) {
      if (passed++ >= skipped) indices.push(index);
    }
    return indices;
  }
}
