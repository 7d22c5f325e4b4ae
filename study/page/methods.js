// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the methods (study/methods/methods.cpp) are ours, and which are for one lamp.

/** What the app does with the modules of 1 mm that are carved here; `ours-for-print` is what it does with larger ones. */
export const kDefaultMethod = 'ours-whole-modules', kDefaultOfLarge = 'ours-for-print';

/** @param {string} method */
export const isOurs = (method) => method.startsWith('ours-');

const kForOneLamp = ['one-light-2020', 'ours-one-light'];

/** Carved for one lamp, and read under it. @param {string} method */
export const isForOneLamp = (method) => kForOneLamp.includes(method);
