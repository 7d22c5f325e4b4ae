// SPDX-License-Identifier: GPL-3.0-or-later
// Undo history: states to move back and forth between.

const kMostStates = 200;
const kMostBytes = 512 * 1024 * 1024; // limit for models that are no longer open
const kOneChangeMs = 1000; // edits of one field within this time count as one change

/** @template State */
export class History {
  /**
   * @param {object} options
   * @param {(a: State, b: State) => boolean} options.same
   * @param {(state: State) => ArrayBufferView | undefined} options.bytesOf
   *   large data of a state; counted once if shared
   * @param {() => number} [options.now]  ms
   */
  constructor({ same, bytesOf, now = () => performance.now() }) {
    this.same_ = same;
    this.bytesOf_ = bytesOf;
    this.now_ = now;
    /** @type {State[]} */ this.states_ = [];
    this.at_ = -1;
    /** @type {string | undefined} */ this.field_ = undefined; // last edited field
    this.editedMs_ = 0;
  }

  /** Tells whether there is a state that many steps away. @param {number} steps  < 0: back */
  reaches(steps) {
    return this.states_[this.at_ + steps] !== undefined;
  }

  /**
   * Records the state after a change and drops all undone states.
   * @param {State} state
   * @param {string} [field]  edited field; quick edits of the same field are undone together
   */
  record(state, field) {
    if (this.at_ >= 0 && this.same_(this.states_[this.at_], state)) return;
    const now = this.now_();
    const goesOn =
      field !== undefined &&
      field === this.field_ &&
      now - this.editedMs_ < kOneChangeMs &&
      this.at_ > 0 &&
      !this.reaches(1);
    this.field_ = field;
    this.editedMs_ = now;
    if (goesOn) {
      this.states_[this.at_] = state;
      return;
    }
    this.states_.splice(this.at_ + 1, Infinity, state);
    this.at_ += 1;
    this.forgetOldest_();
  }

  /** Replaces the current state, if there is one. @param {State} state */
  amend(state) {
    if (this.at_ >= 0) this.states_[this.at_] = state;
  }

  /**
   * Goes to another state.
   * @param {number} steps  < 0: back
   * @returns {State | undefined}  undefined: there is none that many steps away
   */
  go(steps) {
    if (!this.reaches(steps)) return undefined;
    this.field_ = undefined;
    this.at_ += steps;
    return this.states_[this.at_];
  }

  forgetOldest_() {
    while (this.at_ > 0 && (this.states_.length > kMostStates || this.heldBytes_() > kMostBytes)) {
      this.states_.shift();
      this.at_ -= 1;
    }
  }

  heldBytes_() {
    const held = new Set(this.states_.map(this.bytesOf_));
    held.delete(this.bytesOf_(this.states_[this.at_]));
    return [...held].reduce((sum, bytes) => sum + (bytes?.byteLength ?? 0), 0);
  }
}
