// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether a code is shown as it will be carved, before it is: the user must want it, and the search be quick.
const kPatienceMs = 1000; // where a search takes longer, the next codes are shown without

export class LiveView {
  /** @param {() => boolean} isWanted */
  constructor(isWanted) {
    this.isWanted_ = isWanted;
    this.isSlow_ = false; // the last search took too long
  }

  get isOn() {
    return this.isWanted_() && !this.isSlow_;
  }

  /** Notes that the user may have switched it off: switching it on tries again. */
  update() {
    if (!this.isWanted_()) this.isSlow_ = false;
  }

  /**
   * Does a search, and notes if it takes too long.
   * @template Found
   * @param {() => Promise<Found>} search
   */
  async time(search) {
    const begun = performance.now();
    const found = await search();
    this.isSlow_ = performance.now() - begun > kPatienceMs;
    return found;
  }
}
