// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that are written again when the language changes.
import { onLanguage } from './catalogue.js';

/** @typedef {() => string} Words  returns a text in the current language */

/** @type {Map<Element, Words>} */
const written = new Map();

/** @param {Element} element  stays on the page for good @param {Words} words */
export function write(element, words) {
  written.set(element, words);
  show(element, words);
}

/** @param {Element} element @param {Words} words */
function show(element, words) {
  const text = words();
  if (element.textContent !== text) element.textContent = text; // screen readers would read it again
}

onLanguage(() => written.forEach((words, element) => show(element, words)));
