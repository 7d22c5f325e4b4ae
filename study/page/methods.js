// SPDX-License-Identifier: GPL-3.0-or-later
// The methods (study/methods/methods.cpp) that are ours, and those for one lamp.

/** The app's default; `ours-thick-plus` is the same with patterned finder patterns, as where walls are thin. */
export const kDefaultMethod = 'ours',
  kPatternedFinders = 'ours-thick-plus';

/** @param {string} method */
export const isOurs = (method) => method.startsWith('ours');

/** The two readings of the paper's search: as the program has it, and by the paper's words. */
export const kPublished = 'papp-2022',
  kLiteral = 'papp-2022-literal';

/**
 * Returns the rows of one reading of the paper's search.
 * @param {import('./table.js').Row[]} rows  of a table with the column `search`
 * @param {string} [search]
 */
export const ofSearch = (rows, search = kPublished) => rows.filter((row) => row.search === search);

const kForOneLamp = ['one-light-2020', 'ours-one-light'];

/** True for a method that carves for one lamp and decodes under it. @param {string} method */
export const isForOneLamp = (method) => kForOneLamp.includes(method);
