// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps numbers and their units on one line.

const kUnits = '(?:[kMG]i?B|[cm]?m|px|k?g|min|s|h|%|°)';
const kBeforeUnit = new RegExp(`(?<=[\\d}]) (?=${kUnits}(?![\\p{L}\\p{N}]))`, 'gu');

/** Puts a no-break space between each number, or placeholder of one, and its unit. @param {string} words */
export const withUnitsKept = (words) => words.replace(kBeforeUnit, '\u00a0');
