// SPDX-License-Identifier: GPL-3.0-or-later
// The centre of the code on the model: the only place where the page knows it.

/** @typedef {[number, number, number]} Point */

export class Centre {
  /** @param {(mm: Point) => void} onChange  to show it */
  constructor(onChange) {
    this.onChange_ = onChange;
    /** @type {Point | undefined} */ this.mm_ = undefined;
    this.isGuess_ = false;
  }

  /** In the model's mm; none: not chosen yet. */
  get mm() {
    return this.mm_;
  }

  /** The module's, not the user's: no error if the code has no place there. */
  get isGuess() {
    return this.isGuess_;
  }

  /** The user's, which is kept with the model. */
  get chosenMm() {
    return this.isGuess_ ? undefined : this.mm_;
  }

  /** @param {Point | undefined} mm @param {boolean} [isGuess] */
  put(mm, isGuess = false) {
    this.mm_ = mm;
    this.isGuess_ = isGuess && mm !== undefined;
    if (mm) this.onChange_(mm);
  }

  /** From here on it counts as the user's. */
  accept() {
    this.isGuess_ = false;
  }
}
