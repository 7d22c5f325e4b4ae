// SPDX-License-Identifier: GPL-3.0-or-later
// Shows a code as it will be carved, before it is, if the user wants it and the search is quick.
/** @typedef {import('../engine/types.js').FoundDepths} FoundDepths */

const kPatienceMs = 1000; // where the first pass of a search takes longer, the next codes are shown without

export class LiveView {
  /** @param {() => boolean} isWanted */
  constructor(isWanted) {
    this.isWanted_ = isWanted;
    this.isSlow_ = false; // the last one took too long
    this.resetAt_ = 0;
  }

  get isOn() {
    return this.isWanted_() && !this.isSlow_;
  }

  /** Notes that the user has switched it on or off, or opened a model: the next code is shown so however long the last
   *  one took. */
  reset() {
    this.isSlow_ = false;
    this.resetAt_ = performance.now();
  }

  /**
   * Searches the depths of a code. It is shown with them twice: roughly after the search's first pass, and at its end.
   * @param {(untilShown: boolean) => Promise<FoundDepths | null>} search  true: only until the code is shown with them
   * @param {(depths: FoundDepths) => unknown} [onRough]  gets the depths of the first pass; the search waits for it
   * @returns {Promise<FoundDepths | null>}  those at the end; null: nothing is shown
   */
  async carve(search, onRough = () => {}) {
    const begun = performance.now();
    const rough = await search(true);
    if (begun >= this.resetAt_) this.isSlow_ = performance.now() - begun > kPatienceMs;
    if (!rough) return null;
    await onRough(rough);
    return search(false);
  }
}
