// SPDX-License-Identifier: GPL-3.0-or-later
// Build plugin: reduces a module imported as `message_catalogues.js?language=de` to that language. Without a build,
// under Node and from the development server, the module has all languages.
import { kLanguages } from './languages.js';
import { catalogue } from './message_catalogues.js';

/**
 * Returns the words in one language, without the words that only the command uses.
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
