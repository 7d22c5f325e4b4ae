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

/** The wording of the page, which separates thousands everywhere. @type {typeof wordingWith} */
const pageWordingWith = (words) => ({ ...wordingWith(words), separatesThousands: true });

/** @param {Message} message @param {Catalogue} words @param {typeof wordingWith} wording */
const sentenceWith = (message, words, wording) => (words === kLoading ? '' : sentenceIn(message, wording(words)));

/** @param {Message} message @param {Catalogue} words @param {typeof wordingWith} wording */
function hintWith(message, words, wording) {
  if (words === kLoading) return '';
  return words === kNoWords ? text('page.noWords') : hintIn(message, wording(words));
}

/**
 * Returns the problem or fact that a message states, without full stop; '' until its words have loaded. For files.
 * @param {Message} message
 * @param {Catalogue} [words]
 */
export const plainSentenceOf = (message, words = messageWords.now) => sentenceWith(message, words, wordingWith);

/**
 * Returns the message's advice, or else the advice of its cause; '' if there is none. For files.
 * @param {Message} message
 * @param {Catalogue} [words]
 */
export const plainHintOf = (message, words = messageWords.now) => hintWith(message, words, wordingWith);

/** The same for the page, which keeps numbers and units on one line. @type {typeof plainSentenceOf} */
export const sentenceOf = (message, words = messageWords.now) =>
  withUnitsKept(sentenceWith(message, words, pageWordingWith));

/** The same for the page. @type {typeof plainHintOf} */
export const hintOf = (message, words = messageWords.now) => withUnitsKept(hintWith(message, words, pageWordingWith));

/** Returns a value as a sentence writes it. @param {Value} value */
export const writtenValue = (value) =>
  'cause' in value ? sentenceOf(value.cause) : withUnitsKept(writtenIn(value, pageWordingWith(messageWords.now)));

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
