// SPDX-License-Identifier: GPL-3.0-or-later
// Part of the build: puts the English texts into the markup, for readers without scripts and for the time before
// scripts run.
import { addTexts, text } from './catalogue.js';
import { gallery } from './parts/gallery.js';
import { guide } from './parts/guide.js';
import { method } from './parts/method.js';
import { study } from './parts/study.js';

addTexts({ gallery, guide, method, study });

/** @param {string} words */
export const escaped = (words) => words.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

/** @param {string} key */
const textOf = (key) => escaped(text(/** @type {import('./catalogue.js').Key} */ (key)));

/**
 * Fills empty elements that name a text, and the page's description.
 * @param {string} html
 * @returns {string}
 */
export const fillTexts = (html) =>
  html
    .replace(
      /(<(\w+)\b[^>]*\bdata-text="([^"]+)"[^>]*>)(<\/\2>)/g,
      (_, open, _tag, key, close) => open + textOf(key) + close,
    )
    .replace(
      /(<meta\b[^>]*\bdata-text-content="([^"]+)"[^>]*\bcontent=")(")/g,
      (_, open, key, close) => open + textOf(key) + close,
    );
