// SPDX-License-Identifier: GPL-3.0-or-later
// Makes sentences from messages in the current language, by the rules of messages/sentences.h. Settings have the names
// of their controls. A sentence may be requested before its words have loaded, so code that shows it writes it again in
// its `onLanguage` listener.
import { currentLanguage, kLanguages, text } from './catalogue.js';
import { kComing, kNoWords, messageWords } from './message_words.js';
import { choiceLabel, controlLabel } from './setting_names.js';

/** @typedef {import('../engine/message.js').Message} Message */
/** @typedef {import('../engine/message.js').Value} Value */
/** @typedef {import('./message_words.js').Catalogue} Catalogue */
/** @typedef {import('./message_words.js').Words} Words */

const kMostNamed = 6; // most entries listed by name
const kQuotes = { en: ['“', '”'], de: ['„', '“'] };
const kAnd = { en: ' and ', de: ' und ' };

/**
 * Returns the problem or fact that a message states, without full stop; '' until its words have loaded.
 * @param {Message} message
 * @param {Catalogue} [words]
 */
export function sentenceOf(message, words = messageWords.now) {
  if (words === kComing) return '';
  const entry = words[message.code];
  return entry ? filled(entry, message, words) : unworded(message);
}

/**
 * Returns the message's advice, or else the advice of its cause; '' if there is none.
 * @param {Message} message
 * @param {Catalogue} [words]
 * @returns {string}
 */
export function hintOf(message, words = messageWords.now) {
  if (words === kComing) return '';
  if (words === kNoWords) return text('page.noWords');
  const hint = words[message.code]?.hint;
  if (hint) return filled(hint, message, words);
  for (const value of Object.values(message.values)) if ('cause' in value) return hintOf(value.cause, words);
  return '';
}

/** Adds the capital letter and the full stop that messages lack. @param {string} said */
export function asSentence(said) {
  const capital = said.charAt(0).toUpperCase() + said.slice(1);
  return said === '' || /[.!?…]$/.test(capital) ? capital : `${capital}.`;
}

/** Returns a value as a sentence writes it. @param {Value} value */
export const writtenValue = (value) => written(value, messageWords.now);

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
  return isMessage ? { ...parts, message: sentenceOf(asMessage), hint: hintOf(asMessage) } : parts;
}

/** @param {Words} entry @param {Message} message @param {Catalogue} words */
function filled(entry, { values }, words) {
  const [forms = ''] = [currentLanguage(), ...kLanguages].flatMap((language) => entry[language] ?? []);
  const template = typeof forms === 'string' ? forms : forms[countIn(values) === 1 ? 'one' : 'other'];
  return template.replace(/\{(@?)(\w+)\}/g, (whole, ofSetting, name) => {
    if (ofSetting) return quoted(controlLabel(name));
    return values[name] ? written(values[name], words) : whole;
  });
}

/** @param {Record<string, Value>} values */
const countIn = ({ count }) => (count && 'count' in count ? count.count : undefined);

/** @param {Value} value @param {Catalogue} words @returns {string} */
function written(value, words) {
  if ('count' in value) return digits(value.count, 15);
  if ('number' in value) return digits(value.number, 6);
  if ('lengthMm' in value) return `${digits(value.lengthMm, 3)} mm`;
  if ('angleDeg' in value) return `${digits(value.angleDeg, 3)}°`;
  if ('fraction' in value) return `${Math.round(100 * value.fraction)} %`;
  if ('place' in value) return `(${value.place.map(coordinate).join(currentLanguage() === 'de' ? '; ' : ', ')})`;
  if ('extentMm' in value) return `${value.extentMm.map((mm) => digits(mm, 3)).join(' × ')} mm`;
  if ('quoted' in value) return quoted(value.quoted);
  if ('term' in value) return value.term;
  if ('setting' in value) return quoted(controlLabel(value.setting));
  if ('choice' in value) return choiceLabel(value.choice.key, value.choice.value);
  if ('indices' in value) return listed(value.indices);
  return sentenceOf(value.cause, words);
}

/** @param {string} words */
const quoted = (words) => kQuotes[currentLanguage()].join(words);

/** Formats a coordinate; less than a millionth is rounding error. @param {number} value */
const coordinate = (value) => digits(Math.abs(value) < 1e-6 ? 0 : value, 6);

/**
 * Formats a number like messages/sentences.cpp: it never drops digits before the decimal point, and it uses an exponent
 * for very large and very small numbers.
 * @param {number} value
 * @param {number} significant
 */
function digits(value, significant) {
  const size = Math.abs(value);
  if (size === 0) return '0';
  if (!(size >= 1e-6 && size < 1e15)) return withExponent(value, significant);
  const decimals = Math.max(0, significant - 1 - Math.floor(Math.log10(size)));
  return Number(value.toFixed(decimals)).toLocaleString(currentLanguage(), {
    useGrouping: false,
    maximumFractionDigits: decimals,
  });
}

/** @param {number} value @param {number} significant */
function withExponent(value, significant) {
  const figures = Number(value.toPrecision(significant))
    .toExponential()
    .replace(/e([+-])(\d)$/, 'e$10$2');
  return currentLanguage() === 'de' ? figures.replace('.', ',') : figures;
}

/** @param {number[]} indices */
function listed(indices) {
  const names = indices.slice(0, kMostNamed).map(String);
  if (indices.length > kMostNamed) return `${names.join(', ')}, …`;
  return names.length < 2
    ? names.join()
    : names.slice(0, -1).join(', ') + kAnd[currentLanguage()] + names[names.length - 1];
}

/**
 * Shows the code and the values of a message without words. Tests find such a fault of ours.
 * @param {Message} message
 */
const unworded = ({ code, values }) =>
  [
    code,
    ...Object.entries(values).map(
      ([name, value]) =>
        `${name}=${Object.values(value)
          .map((part) => JSON.stringify(part))
          .join()}`,
    ),
  ].join(' ');
