// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether a code is shown as it will be carved, before it is: the user must want it, and the search be quick.
const kPatienceMs = 1000; // where a search takes longer, the next codes are shown without

export class LiveView {
  /** @param {() => boolean} isWanted */
  constructor(isWanted) {
    this.isWanted_ = isWanted;
    this.isSlow_ = false; // the last search took too long
    this.resetAt_ = 0;
  }

  get isOn() {
    return this.isWanted_() && !this.isSlow_;
  }

  /** Notes that the user has switched it on or off: the next code is shown so however long the last search took. */
  reset() {
    this.isSlow_ = false;
    this.resetAt_ = performance.now();
  }

  /**
   * Does a search, and notes if it takes too long.
   * @template Found
   * @param {() => Promise<Found>} search
   */
  async time(search) {
    const begun = performance.now();
    const found = await search();
    if (begun >= this.resetAt_) this.isSlow_ = performance.now() - begun > kPatienceMs;
    return found;
  }
}
