// SPDX-License-Identifier: GPL-3.0-or-later
// Uses the moments in which nothing is asked for: what the next carving begins with is begun, and its reader is loaded.
const kQuietMs = 600;  // with nothing new: who turns or types goes on within that time, as a rule
const kSignsOfUse = ['pointermove', 'pointerdown', 'keydown', 'focusin'];  // without one, the page may be open for nobody

export class Preparing {
  /**
   * @param {object} options
   * @param {Pick<import('../engine/client.js').EngineClient, 'prepareEngrave'>} options.client
   * @param {() => void} options.prepareReader
   * @param {() => boolean} options.isBusy
   * @param {Pick<EventTarget, 'addEventListener' | 'removeEventListener'>} options.user  where its signs are seen
   */
  constructor({ client, prepareReader, isBusy, user }) {
    this.client_ = client;
    this.prepareReader_ = prepareReader;
    this.isBusy_ = isBusy;
    this.isUsed_ = false;
    this.isPlaced_ = false;
    /** @type {ReturnType<typeof setTimeout> | undefined} */ this.timer_ = undefined;
    const use = () => {
      for (const sign of kSignsOfUse) user.removeEventListener(sign, use, { capture: true });
      this.isUsed_ = true;
      this.plan_();
    };
    for (const sign of kSignsOfUse) user.addEventListener(sign, use, { capture: true, passive: true });
  }

  /** @param {boolean} isPlaced  anew, or not any more */
  note(isPlaced) {
    this.isPlaced_ = isPlaced;
    this.plan_();
  }

  plan_() {
    clearTimeout(this.timer_);
    if (this.isUsed_ && this.isPlaced_) this.timer_ = setTimeout(() => this.prepare_(), kQuietMs);
  }

  prepare_() {
    if (this.isBusy_()) return;
    this.client_.prepareEngrave()
      .catch(() => {})  // what went wrong, carving meets again, or the client tells
      .finally(() => this.prepareReader_());  // after it: together they would keep the page from answering
  }
}
