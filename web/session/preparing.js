// SPDX-License-Identifier: GPL-3.0-or-later
// Uses the moments in which nothing is asked for: what the next carving begins with is begun, and its reader is loaded.
const kQuietMs = 600;  // without a sign of use: it would have to wait for what is prepared
const kSignsOfUse = ['pointermove', 'pointerdown', 'wheel', 'keydown', 'focusin'];  // before the first, nobody may be there

export class Preparing {
  /**
   * @param {object} options
   * @param {Pick<import('../engine/client.js').EngineClient, 'prepareEngrave'>} options.client
   * @param {() => void} options.prepareReader
   * @param {() => boolean} options.isBusy
   * @param {Pick<EventTarget, 'addEventListener'>} options.user  where its signs are seen
   * @param {(event: Event) => boolean} options.isOverModel  where the module has to answer every move
   */
  constructor({ client, prepareReader, isBusy, user, isOverModel }) {
    this.client_ = client;
    this.prepareReader_ = prepareReader;
    this.isBusy_ = isBusy;
    this.isUsed_ = false;
    this.isDue_ = false;  // a code has its place, and nothing is prepared for it
    /** @type {ReturnType<typeof setTimeout> | undefined} */ this.timer_ = undefined;
    const use = (/** @type {Event} */ event) => {
      const isFirst = !this.isUsed_;
      this.isUsed_ = true;
      if (isFirst || event.type !== 'pointermove' || isOverModel(event)) this.plan();  // on its way to Engrave it asks for nothing
    };
    for (const sign of kSignsOfUse) user.addEventListener(sign, use, { capture: true, passive: true });
  }

  /** @param {boolean} isPlaced  anew, or not any more */
  note(isPlaced) {
    this.isDue_ = isPlaced;
    this.plan();
  }

  /** Prepares the next carving after a quiet moment, if it is due. */
  plan() {
    clearTimeout(this.timer_);
    if (this.isUsed_ && this.isDue_) this.timer_ = setTimeout(() => this.prepare_(), kQuietMs);
  }

  prepare_() {
    if (this.isBusy_()) return;
    this.isDue_ = false;
    this.client_.prepareEngrave()
      .catch(() => {})  // what went wrong, carving meets again, or the client tells
      .finally(() => this.prepareReader_());  // after it: together they would keep the page from answering
  }
}
