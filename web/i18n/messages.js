// SPDX-License-Identifier: GPL-3.0-or-later
// Makes sentences from messages in the current language (sentences.js). A sentence may be requested before its words
// have loaded, so code that shows it writes it again in its `onLanguage` listener.
import { appTexts, currentLanguage, text } from './catalogue.js';
import { kLoading, kNoWords, messageWords } from './message_words.js';
import { hintIn, sentenceIn, writtenIn } from './sentences.js';
import { withUnitsKept } from './units.js';

/** @typedef {import('../engine/message.js').Message} Message */
/** @typedef {import('../engine/message.js').Value} Value */
/** @typedef {import('./sentences.js').Catalogue} Catalogue */

/** @param {Catalogue} words @returns {import('./sentences.js').Wording} */
const wordingWith = (words) => ({ language: currentLanguage(), words, names: appTexts() });

/**
 * Returns the problem or fact that a message states, without full stop; '' until its words have loaded. For files.
 * @param {Message} message
 * @param {Catalogue} [words]
 */
export const plainSentenceOf = (message, words = messageWords.now) =>
  words === kLoading ? '' : sentenceIn(message, wordingWith(words));

/**
 * Returns the message's advice, or else the advice of its cause; '' if there is none. For files.
 * @param {Message} message
 * @param {Catalogue} [words]
 * @returns {string}
 */
export function plainHintOf(message, words = messageWords.now) {
  if (words === kLoading) return '';
  return words === kNoWords ? text('page.noWords') : hintIn(message, wordingWith(words));
}

/** The same for the page, which keeps numbers and units on one line. @type {typeof plainSentenceOf} */
export const sentenceOf = (...given) => withUnitsKept(plainSentenceOf(...given));

/** The same for the page. @type {typeof plainHintOf} */
export const hintOf = (...given) => withUnitsKept(plainHintOf(...given));

/** Returns a value as a sentence writes it. @param {Value} value */
export const writtenValue = (value) =>
  'cause' in value ? sentenceOf(value.cause) : withUnitsKept(writtenIn(value, wordingWith(messageWords.now)));

/**
 * Returns a value of a report with the sentence and the hint added to each message in it, for people who read the file.
 * @param {unknown} value
 * @returns {unknown}
 */
export function worded(value) {
  if (Array.isArray(value)) return value.map(worded);
  if (typeof value !== 'object' || value === null) return value;
  const parts = Object.fromEntries(
    Object.entries(value).map(([name, part]) => [name, name === 'values' ? part : worded(part)]),
  );
  const isMessage = 'code' in value && 'values' in value;
  const asMessage = /** @type {Message} */ (value);
  return isMessage ? { ...parts, message: plainSentenceOf(asMessage), hint: plainHintOf(asMessage) } : parts;
}
