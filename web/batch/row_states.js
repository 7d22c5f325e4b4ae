// SPDX-License-Identifier: GPL-3.0-or-later
// States of a batch's rows: one byte per row, plus the reasons of failed rows.

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

  /** Number of rows that are done or failed. */
  get finished() {
    return this.counts.done + this.counts.failed;
  }

  /** @param {number} index @returns {RowState} */
  of(index) {
    return kStates[this.states_[index]];
  }

  /** Returns the reason of a failed row; '' for other rows. @param {number} index */
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

  /** Returns the first row in this state at or after an index, or -1. @param {RowState} state @param {number} [from] */
  next(state, from = 0) {
    return this.states_.indexOf(kStates.indexOf(state), from);
  }

  /**
   * Returns up to `count` indices of the rows in this state, after the first `skipped`.
   * @param {RowState | 'all'} state
   * @param {number} skipped
   * @param {number} count
   */
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
