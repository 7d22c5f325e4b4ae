// SPDX-License-Identifier: GPL-3.0-or-later
// States to go back and forth between.

const kMostStates = 200;
const kMostBytes = 512 * 1024 * 1024;  // of models that are no longer open
const kOneChangeMs = 1000;             // edits of one field in quicker succession are one change

/** @template State */
export class History {
  /**
   * @param {object} options
   * @param {(a: State, b: State) => boolean} options.same
   * @param {(state: State) => ArrayBufferView | undefined} options.bytesOf  what makes a state large; shared ones count once
   * @param {() => number} [options.now]  ms
   */
  constructor({ same, bytesOf, now = () => performance.now() }) {
    this.same_ = same;
    this.bytesOf_ = bytesOf;
    this.now_ = now;
    /** @type {State[]} */ this.states_ = [];
    this.at_ = -1;
    /** @type {string | undefined} */ this.field_ = undefined;  // that was edited last
    this.editedMs_ = 0;
  }

  get canUndo() {
    return this.at_ > 0;
  }

  get canRedo() {
    return this.at_ < this.states_.length - 1;
  }

  /**
   * The state after a change; what had been undone cannot be redone any more.
   * @param {State} state
   * @param {string} [field]  that was edited; quick edits of the same one are undone together
   */
  record(state, field) {
    if (this.at_ >= 0 && this.same_(this.states_[this.at_], state)) return;
    const now = this.now_();
    const goesOn = field !== undefined && field === this.field_ && now - this.editedMs_ < kOneChangeMs && this.at_ > 0 && !this.canRedo;
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

  /** @returns {State | undefined}  the one before */
  undo() {
    return this.canUndo ? this.go_(-1) : undefined;
  }

  /** @returns {State | undefined}  the one that was undone last */
  redo() {
    return this.canRedo ? this.go_(1) : undefined;
  }

  /** @param {number} step */
  go_(step) {
    this.field_ = undefined;
    this.at_ += step;
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
