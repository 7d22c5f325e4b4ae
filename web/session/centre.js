// SPDX-License-Identifier: GPL-3.0-or-later
// Holds the centre of the code on the model. No other part of the page does.

/** @typedef {[number, number, number]} Point */

export class Centre {
  /** @param {(mm: Point) => void} onChange  shows it */
  constructor(onChange) {
    this.onChange_ = onChange;
    /** @type {Point | undefined} */ this.mm_ = undefined;
    this.isGuess_ = false;
  }

  /** Centre in the model's mm; undefined: not chosen yet. */
  get mm() {
    return this.mm_;
  }

  /** True if the module proposed the centre. Then it is no error if the code does not fit there. */
  get isGuess() {
    return this.isGuess_;
  }

  /** Centre chosen by the user, which is stored with the model. */
  get chosenMm() {
    return this.isGuess_ ? undefined : this.mm_;
  }

  /** @param {Point | undefined} mm @param {boolean} [isGuess] */
  put(mm, isGuess = false) {
    this.mm_ = mm;
    this.isGuess_ = isGuess && mm !== undefined;
    if (mm) this.onChange_(mm);
  }

  /** Treats the centre as chosen by the user from now on. */
  accept() {
    this.isGuess_ = false;
  }
}
