// SPDX-License-Identifier: GPL-3.0-or-later
// Uses idle moments to start the next carving's first steps and to load its decoder. These steps include the first
// search for depths, so that the placed code is shown as it will be carved.
const kQuietMs = 300; // idle time before preparing: user input has to wait while the module prepares
// Events of a user. Nothing is prepared before the first one.
const kSignsOfUse = ['pointermove', 'pointerdown', 'wheel', 'keydown', 'focusin'];

export class IdlePreparation {
  /**
   * @param {object} options
   * @param {Pick<import('../engine/client.js').EngineClient, 'prepareEngrave'>} options.client
   * @param {() => void} options.prepareReader
   * @param {() => boolean} options.isBusy
   * @param {import('../view/live_view.js').LiveView} options.live
   * @param {(depths: import('../engine/types.js').FoundDepths) => void} options.onDepths  of the code that is shown so
   * @param {Pick<EventTarget, 'addEventListener'>} options.user  target of the user's events
   * @param {(event: Event) => boolean} options.isOverModel  true: the module has to answer each move
   */
  constructor({ client, prepareReader, isBusy, live, onDepths, user, isOverModel }) {
    this.client_ = client;
    this.prepareReader_ = prepareReader;
    this.isBusy_ = isBusy;
    this.live_ = live;
    this.onDepths_ = onDepths;
    this.isUsed_ = false;
    this.isDue_ = false; // a code is placed and nothing is prepared for it yet
    /** @type {ReturnType<typeof setTimeout> | undefined} */ this.timer_ = undefined;
    const use = (/** @type {Event} */ event) => {
      const isFirst = !this.isUsed_;
      this.isUsed_ = true;
      // Off the model, a pointer moving to the Engrave button needs no answer and does not postpone.
      if (isFirst || event.type !== 'pointermove' || isOverModel(event)) this.plan();
    };
    for (const sign of kSignsOfUse) user.addEventListener(sign, use, { capture: true, passive: true });
  }

  /** Notes a new placement. @param {boolean} isPlaced  false: there is no placement any more */
  setPlaced(isPlaced) {
    this.isDue_ = isPlaced;
    this.plan();
  }

  /** Prepares the next carving after a quiet moment, if it is due. */
  plan() {
    clearTimeout(this.timer_);
    if (this.isUsed_ && this.isDue_) this.timer_ = setTimeout(() => void this.prepare_(), kQuietMs);
  }

  async prepare_() {
    if (this.isBusy_()) return;
    this.isDue_ = false;
    try {
      const depths = await (this.live_.isOn
        ? this.live_.carve((untilShown) => this.client_.prepareEngrave({ search: true, untilShown }))
        : this.client_.prepareEngrave({ search: false }));
      if (depths && !this.isDue_) this.onDepths_(depths); // else the code has moved on
    } catch {
      // carving meets the error again, or the client reports it
    }
    this.prepareReader_(); // afterwards: both at once would block the page
  }
}
