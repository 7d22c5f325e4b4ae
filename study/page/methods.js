// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the methods (study/methods/methods.cpp) are ours, and which are for one lamp.

/** What the app carves unless told otherwise; `ours-thick-plus` is the same with patterned finders, as where walls are thin. */
export const kDefaultMethod = 'ours', kPatternedFinders = 'ours-thick-plus';

/** @param {string} method */
export const isOurs = (method) => method.startsWith('ours');

const kForOneLamp = ['one-light-2020', 'ours-one-light'];

/** Carved for one lamp, and read under it. @param {string} method */
export const isForOneLamp = (method) => kForOneLamp.includes(method);
