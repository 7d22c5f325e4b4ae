// SPDX-License-Identifier: GPL-3.0-or-later
// Part of the build: puts the English texts into the markup, for readers without scripts and for the time before
// scripts run.
import { startTexts, text } from './catalogue.js';

await startTexts('gallery', 'guide', 'method', 'study');

/** @param {string} words */
export const escaped = (words) => words.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

/** @param {string} key */
const textOf = (key) => escaped(text(/** @type {import('./catalogue.js').Key} */ (key)));

/**
 * Fills empty elements that name a text, the page's description, and the texts that stand for pictures.
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
      /(<(?:meta|img)\b[^>]*\bdata-text-(content|alt)="([^"]+)"[^>]*\s\2=")(")/g,
      (_, open, _attribute, key, close) => open + textOf(key) + close,
    );
