// SPDX-License-Identifier: GPL-3.0-or-later
// Makes sentences from messages in a language, by the rules of messages/sentences.h. Settings have the names of the
// page's controls.
import { choiceIn, labelIn } from './setting_words.js';

/** @typedef {import('../engine/message.js').Message} Message */
/** @typedef {import('../engine/message.js').Value} Value */
/** @typedef {string | { one: string, other: string }} Forms  the value `count`, a count or a number, selects the form */
/** @typedef {{ says: Forms, hint?: Forms }} Entry */
/** @typedef {Record<string, Entry>} Catalogue  by message code */
/** @typedef {{ quotes: string[], and: string, between: string }} Format  `between`: separates coordinates */
/**
 * The language of sentences, the words of messages, and the names of settings in it.
 * @typedef {{ language: string, words: Catalogue, names: import('./setting_words.js').Names & { format: Format },
 *   separatesThousands?: boolean }} Wording
 */

const kMostNamed = 6; // most entries listed by name

/**
 * Returns the problem or fact that a message states, without full stop.
 * @param {Message} message
 * @param {Wording} wording
 */
export function sentenceIn(message, wording) {
  const entry = wording.words[message.code];
  return entry ? filled(entry.says, message, wording) : unworded(message);
}

/**
 * Returns the message's advice, or else the advice of its cause; '' if there is none.
 * @param {Message} message
 * @param {Wording} wording
 * @returns {string}
 */
export function hintIn(message, wording) {
  const hint = wording.words[message.code]?.hint;
  if (hint) return filled(hint, message, wording);
  for (const value of Object.values(message.values)) if ('cause' in value) return hintIn(value.cause, wording);
  return '';
}

/** Adds the capital letter and the full stop that messages lack. @param {string} said */
export function asSentence(said) {
  const capital = said.charAt(0).toUpperCase() + said.slice(1);
  return said === '' || /[.!?…]$/.test(capital) ? capital : `${capital}.`;
}

/** @param {Forms} forms @param {Message} message @param {Wording} wording */
function filled(forms, { values }, wording) {
  const template = typeof forms === 'string' ? forms : forms[countIn(values) === 1 ? 'one' : 'other'];
  return template.replace(/\{(@?)(\w+)\}/g, (whole, ofSetting, name) => {
    if (ofSetting) return quoted(labelIn(wording.names, name), wording);
    return values[name] ? writtenIn(values[name], wording) : whole;
  });
}

/** @param {Record<string, Value>} values */
const countIn = ({ count }) => count && ('number' in count ? count.number : 'count' in count ? count.count : undefined);

/**
 * Returns a value as a sentence writes it.
 * @param {Value} value
 * @param {Wording} wording
 * @returns {string}
 */
export function writtenIn(value, wording) {
  const { names } = wording;
  if ('count' in value) return digits(value.count, 15, wording);
  if ('index' in value) return digits(value.index, 15, { language: wording.language });
  if ('number' in value) return digits(value.number, 6, wording);
  if ('lengthMm' in value) return `${digits(rounded(value.lengthMm), 3, wording)} mm`;
  if ('angleDeg' in value) return `${digits(rounded(value.angleDeg), 3, wording)}°`;
  if ('fraction' in value) return `${digits(Math.round(100 * value.fraction), 15, wording)} %`;
  if ('place' in value) return placed(value.place, wording);
  if ('extentMm' in value) return `${value.extentMm.map((mm) => digits(rounded(mm), 3, wording)).join(' × ')} mm`;
  if ('quoted' in value) return quoted(value.quoted, wording);
  if ('term' in value) return value.term;
  if ('setting' in value) return quoted(labelIn(names, value.setting), wording);
  if ('choice' in value) return choiceIn(names, value.choice.key, value.choice.value);
  if ('indices' in value) return listed(value.indices, names.format);
  return sentenceIn(value.cause, wording);
}

/** @param {string} words @param {Wording} wording */
const quoted = (words, { names: { format } }) => format.quotes.join(words);

/**
 * Returns 0 in place of a rounding error: less than a nanometre, or a millionth of a unit of the file.
 * @param {number} value
 */
const rounded = (value) => (Math.abs(value) < 1e-6 ? 0 : value);

/** Formats a point; its coordinates have separators of their own. @param {number[]} place @param {Wording} wording */
function placed(place, { language, names: { format } }) {
  const coordinates = place.map((value) => digits(rounded(value), 6, { language }));
  return `(${coordinates.join(format.between)})`;
}

/**
 * Formats a number like messages/sentences.cpp: it never drops digits before the decimal point, and it uses an exponent
 * for very large and very small numbers.
 * @param {number} value
 * @param {number} significant
 * @param {Pick<Wording, 'language' | 'separatesThousands'>} wording
 */
function digits(value, significant, { language, separatesThousands = false }) {
  const size = Math.abs(value);
  if (size === 0) return '0';
  if (!(size >= 1e-6 && size < 1e15)) return withExponent(value, significant, language);
  const decimals = Math.max(0, significant - 1 - Math.floor(Math.log10(size)));
  return Number(value.toFixed(decimals)).toLocaleString(language, {
    useGrouping: separatesThousands,
    maximumFractionDigits: decimals,
  });
}

/** @param {number} value @param {number} significant @param {string} language */
function withExponent(value, significant, language) {
  const figures = Number(value.toPrecision(significant))
    .toExponential()
    .replace(/e([+-])(\d)$/, 'e$10$2');
  return figures.replace('.', (0.5).toLocaleString(language).charAt(1));
}

/** @param {number[]} indices @param {Format} format */
function listed(indices, { and }) {
  const names = indices.slice(0, kMostNamed).map(String);
  if (indices.length > kMostNamed) return `${names.join(', ')}, …`;
  return names.length < 2 ? names.join() : names.slice(0, -1).join(', ') + and + names[names.length - 1];
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
