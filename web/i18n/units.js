// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps a number on one line with its unit, and with a short word before it, such as "at 8°".

const kNumber = '(?:[−-]?\\d[\\d.,]*|\\{\\w+\\})';
const kUnit = '(?:[kMG]i?B|[cm]?m|px|k?g|min|s|h|%|°)(?![\\p{L}\\p{N}])';
const kShortWord = '(?<![\\p{L}\\p{N}])\\p{L}{1,3}';
const kBeforeUnit = new RegExp(`(?<=[\\d}]) (?=${kUnit})`, 'gu');
const kBeforeNumber = new RegExp(`(?<=${kShortWord}) (?=${kNumber}\u00a0?${kUnit})`, 'gu');

/** Keeps each number with its unit, and a short word before it, on one line. A number may be a name in braces. @param {string} words */
export const withUnitsKept = (words) => words.replace(kBeforeUnit, '\u00a0').replace(kBeforeNumber, '\u00a0');
