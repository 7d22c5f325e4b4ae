// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of each language, part by part. This is what Node uses; locale_plugin.js puts imports in its place, so that
// the page loads only the parts it shows.
import { kLanguageFiles, partOf } from './locale_files.js';

/** @typedef {import('./locale_files.js').Part} Part */

/** The languages, English first. */
export const kLanguages = kLanguageFiles;

/** The part `app` in English, which is always there. @type {import('./catalogue.js').AppTexts} */
export const kEnglish = partOf('en', 'app');

/**
 * Loads a part, with English texts where the language has none.
 * @param {string} language
 * @param {Part} part
 * @returns {Promise<any>}
 */
export const load = async (language, part) => partOf(language, part);
