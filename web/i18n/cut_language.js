// SPDX-License-Identifier: GPL-3.0-or-later
// Part of the build: of a module that is imported as `message_catalogues.js?language=de` only that language is left. Where
// nothing is built, under Node and from the development server, it has all of them.
import { kLanguages } from './catalogue.js';
import { catalogue } from './message_catalogues.js';

/**
 * Without the other languages, and without what only the command says.
 * @param {string} language
 * @returns {import('./message_words.js').Catalogue}
 */
export function wordsIn(language) {
  const left = new Set(['command', ...kLanguages.filter((other) => other !== language)]);
  return JSON.parse(JSON.stringify(catalogue, (key, value) => (left.has(key) ? undefined : value)));
}

/** @returns {import('vite').Plugin} */
export function oneLanguage() {
  return {
    name: 'qrelief-one-language',
    apply: 'build',
    load: {
      filter: { id: /\/message_catalogues\.js\?language=\w+$/ },
      handler: (id) => `export const catalogue = ${JSON.stringify(wordsIn(id.slice(id.indexOf('=') + 1)))};`,
    },
  };
}
