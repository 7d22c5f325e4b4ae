// SPDX-License-Identifier: GPL-3.0-or-later
// The core's English sentences in the page's words and language; what is not known stays as it is.
import { currentLanguage, textOr } from './catalogue.js';
import { kPatterns } from './parts/core.js';

const kMarks = /[\\^$.*+?()[\]{}|]/g;

/** Longer ones first: they say more. */
const kRecognisers = [...kPatterns].sort((a, b) => b.length - a.length).map((pattern) => ({
  pattern,
  expression: new RegExp(`^${pattern.split(/\{\d\}/).map((part) => part.replace(kMarks, '\\$&')).join('(.+?)')}\\.?$`, 's'),
  names: [...pattern.matchAll(/\{(\d)\}/g)].map(([, name]) => name),
}));

/** A number in a sentence as the language writes it. @param {string} value */
const inLanguage = (value) => (currentLanguage() === 'de' && /^-?\d+\.\d+$/.test(value) ? value.replace('.', ',') : value);

/** @param {string} sentence */
export function coreWords(sentence) {
  const plain = sentence.replaceAll('`', '').replaceAll("'s ", '’s ');  // names of patterns stand between ticks
  for (const { pattern, expression, names } of kRecognisers) {
    const found = expression.exec(plain);
    if (!found) continue;
    return textOr('core', pattern, plain, Object.fromEntries(names.map((name, i) => [name, inLanguage(found[i + 1])])));
  }
  return plain;
}
