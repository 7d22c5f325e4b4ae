// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that follow the language after they were written.
import { onLanguage } from './catalogue.js';

/** @typedef {() => string} Words  a text in the language chosen */

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
  if (element.textContent !== text) element.textContent = text;  // the same again would be read out again
}

onLanguage(() => written.forEach((words, element) => show(element, words)));
