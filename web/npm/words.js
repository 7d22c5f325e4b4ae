// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences of messages and errors, and the English text of each error.
import { wordErrors } from '../engine/engine_error.js';
import { kEnglish, kLanguages, load } from '../i18n/locales.js';
import { asSentence, hintIn, sentenceIn } from '../i18n/sentences.js';

/** @typedef {import('../engine/message.js').Message} Message */

/** The loaded languages by code. @type {Map<string, import('../i18n/sentences.js').Wording>} */
const loaded = new Map([['en', { language: 'en', words: await load('en', 'messages'), names: kEnglish }]]);

/** The languages of sentences: English, which is always there, and those that `loadLanguage` loads. */
export const languages = kLanguages;

/**
 * Loads a language, so that `sentence` and `hint` know it.
 * @param {string} code  of `languages`: "de"
 * @throws {RangeError} if there is no such language
 */
export async function loadLanguage(code) {
  if (!kLanguages.some((one) => one.code === code))
    throw new RangeError(
      `There is no language ${JSON.stringify(code)}. The languages are ${kLanguages.map((one) => one.code).join(', ')}.`,
    );
  const [words, names] = await Promise.all([load(code, 'messages'), load(code, 'app')]);
  loaded.set(code, { language: code, words, names });
}

/**
 * Returns the sentence of a message, such as `verdict.reads.summary`, or of an EngineError. Other errors have only their
 * own text.
 * @param {Message | Error} said
 * @param {string} [language]  English, or a loaded one
 * @returns {string}
 */
export function sentence(said, language = 'en') {
  return isMessage(said) ? asSentence(sentenceIn(said, wordingIn(language))) : said.message;
}

/**
 * Returns the advice that belongs to a message or an EngineError; '' if there is none.
 * @param {Message | Error} said
 * @param {string} [language]  English, or a loaded one
 * @returns {string}
 */
export const hint = (said, language = 'en') => (isMessage(said) ? asSentence(hintIn(said, wordingIn(language))) : '');

/** @param {Message | Error} said @returns {said is Message} */
const isMessage = (said) => 'code' in said && 'values' in said;

/** @param {string} language */
function wordingIn(language) {
  const wording = loaded.get(language);
  if (!wording)
    throw new RangeError(`The language ${JSON.stringify(language)} is not loaded: call loadLanguage first.`);
  return wording;
}

wordErrors((said) => sentence(said));
