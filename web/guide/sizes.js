// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Symbols and the number of letters that fit: bytes of UTF-8 at error correction M [ISO/IEC 18004, table 7].
 * @type {readonly { version: number, letters: number, modules: number }[]}
 */
export const kSizes = [
  [1, 14],
  [2, 26],
  [3, 42],
  [4, 62],
  [6, 106],
  [10, 213],
].map(([version, letters]) => ({ version, letters, modules: 17 + 4 * version }));

/**
 * Returns the width of a symbol without its quiet zone, mm.
 * @param {number} modules
 * @param {number} moduleMm
 */
export const widthMm = (modules, moduleMm) => modules * moduleMm;
