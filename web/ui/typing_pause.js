// SPDX-License-Identifier: GPL-3.0-or-later
// Waits for a pause in typing.

const kTypingPauseMs = 250;

export class TypingPause {
  /** @param {() => unknown} act  called once typing has paused */
  constructor(act) {
    this.act_ = act;
    /** @type {ReturnType<typeof setTimeout> | undefined} */ this.timer_ = undefined;
  }

  /** Starts the pause anew after a keystroke. */
  typed() {
    clearTimeout(this.timer_);
    this.timer_ = setTimeout(() => void this.settle(), kTypingPauseMs);
  }

  /** Waits no longer, and does not act. */
  forget() {
    clearTimeout(this.timer_);
    this.timer_ = undefined;
  }

  /** Acts now if a pause has begun. */
  async settle() {
    if (this.timer_ === undefined) return;
    this.forget();
    await this.act_();
  }
}
