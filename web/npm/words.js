// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences of messages and errors, and the English text of each error.
import { wordErrors } from '../engine/engine_error.js';
import { catalogue as de } from '../i18n/message_catalogues.js?language=de';
import { catalogue as en } from '../i18n/message_catalogues.js?language=en';
import { kLanguages } from '../i18n/languages.js';
import { asSentence, hintIn, sentenceIn } from '../i18n/sentences.js';

/** @typedef {import('../engine/message.js').Message} Message */
/** @typedef {import('../i18n/languages.js').Language} Language */

/** @type {Record<Language, import('../i18n/sentences.js').Catalogue>} */
const kWords = { en, de };

/**
 * Returns the sentence of a message, such as `verdict.reads.summary`, or of an EngineError. Other errors have only their
 * own text.
 * @param {Message | Error} said
 * @param {Language} [language]  default: en
 * @returns {string}
 */
export function sentence(said, language = 'en') {
  return isMessage(said) ? asSentence(sentenceIn(said, wordingIn(language))) : said.message;
}

/**
 * Returns the advice that belongs to a message or an EngineError; '' if there is none.
 * @param {Message | Error} said
 * @param {Language} [language]  default: en
 * @returns {string}
 */
export const hint = (said, language = 'en') => (isMessage(said) ? asSentence(hintIn(said, wordingIn(language))) : '');

/** @param {Message | Error} said @returns {said is Message} */
const isMessage = (said) => 'code' in said && 'values' in said;

/** @param {Language} language */
function wordingIn(language) {
  if (!kLanguages.includes(language))
    throw new RangeError(
      `There is no language ${JSON.stringify(language)}. The languages are ${kLanguages.join(', ')}.`,
    );
  return { language, words: kWords[language] };
}

wordErrors((said) => sentence(said));
