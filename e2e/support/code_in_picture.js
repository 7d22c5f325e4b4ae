// SPDX-License-Identifier: GPL-3.0-or-later
// What lies round a QR code in a picture of the page.
import { findCode } from './decode.js';
import { readPng } from './read_png.js';

const kModules = 21; // of the shortest codes
const kDark = 0.6; // of the brightness of the quiet zone

/**
 * Finds the code of 21 × 21 modules in a picture of an element. The code must stand upright.
 * @param {import('@playwright/test').Locator} element
 * @returns {Promise<CodeInPicture | undefined>}  undefined: no code is found
 */
export async function lookRound(element) {
  const png = await element.screenshot();
  const symbol = await findCode(png);
  if (!symbol) return undefined;
  const { topLeft, bottomRight } = symbol.position;
  return new CodeInPicture(readPng(png), topLeft, (bottomRight.x - topLeft.x) / kModules);
}

class CodeInPicture {
  /** @param {import('./read_png.js').Pixels} picture @param {{ x: number, y: number }} corner @param {number} module */
  constructor(picture, corner, module) {
    this.picture_ = picture;
    this.corner_ = corner;
    this.module_ = module;
    this.light_ = this.at_(-2, -2);
  }

  get moduleWidth() {
    return this.module_;
  }

  /** Returns the brightness at a place in modules from the symbol's upper left. @param {number} x @param {number} y */
  at_(x, y) {
    const { width, channels, data } = this.picture_;
    const [column, row] = [this.corner_.x + x * this.module_, this.corner_.y + y * this.module_].map(Math.floor);
    return data[channels * (row * width + column) + 1]; // of green
  }

  /**
   * Tells whether the place next to the middle of a side is dark.
   * @param {string} side  'left', 'above' or 'right' @param {number} away  modules from the symbol
   */
  isDark(side, away) {
    const middle = kModules / 2;
    const [x, y] = side === 'above' ? [middle, -away] : [side === 'left' ? -away : kModules + away, middle];
    return this.at_(x, y) < kDark * this.light_;
  }

  /** Returns the dark share of a strip under the symbol, as wide as it. @param {number} from  modules below it @param {number} to */
  darkShare(from, to) {
    const [columns, rows] = [100, 20];
    let dark = 0;
    for (let i = 0; i < columns * rows; i += 1) {
      const x = ((i % columns) + 0.5) * (kModules / columns);
      const y = kModules + from + ((to - from) * (Math.floor(i / columns) + 0.5)) / rows;
      if (this.at_(x, y) < kDark * this.light_) dark += 1;
    }
    return dark / (columns * rows);
  }
}
