// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences about tables, in any language. The data decide which sentence is chosen and its values.
import { filled } from '../../web/i18n/catalogue.js';
import de from '../locales/de.json' with { type: 'json' };
import en from '../locales/en.json' with { type: 'json' };

/** @typedef {'en' | 'de'} Language  of the study */
/** @typedef {keyof typeof en} Word */
/** @typedef {{ say: Word, with?: Record<string, Value> }} Said */
/** A number with `digits` after the point. @typedef {{ number: number, digits: number }} Measured */
/** @typedef {string | number | Measured | Said | Said[]} Value  several make a list */

/** The words of the figures. */
export const kWords = { en, de };

/** The languages of the study. */
export const kLanguages = /** @type {Language[]} */ (Object.keys(kWords));

/** @param {Word} word @param {Record<string, Value>} [values] @returns {Said} */
export const said = (word, values) => (values ? { say: word, with: values } : { say: word });

/** @param {number} value @returns {Measured} */
export const mm = (value) => ({ number: value, digits: 2 });

/**
 * Returns a name from a table, such as `name('model', 'bunny')`; a name without words stays as in the table.
 * @param {string} kind
 * @param {string} value
 * @returns {Said}
 */
export function name(kind, value) {
  const word = /** @type {Word} */ (`${kind}-${value}`);
  return word in en ? said(word) : said('asIs', { value });
}

/** Says "on all 8 models", "on 3 of 8 models". @param {import('./compare.js').Tally} tally @returns {Said} */
export const models = ({ holds, of }) =>
  said(holds === of ? 'onAllModels' : holds === 0 ? 'onNoModel' : 'onSomeModels', { holds, of });

/** Says "in all 8 cases", "in both cases". @param {import('./compare.js').Tally} tally @returns {Said} */
export function cases({ holds, of }) {
  if (of === 1) return said(holds === 1 ? 'inOnlyCase' : 'notInOnlyCase', { holds, of });
  if (holds === of) return said(of === 2 ? 'inBothCases' : 'inAllCases', { holds, of });
  return said(holds === 0 ? 'inNoCase' : 'inSomeCases', { holds, of });
}

/**
 * True if the tables have every value of a sentence: every number is a number, and every count is over at least one
 * case.
 * @param {Value} value
 * @returns {boolean}
 */
export function isKnown(value) {
  if (typeof value === 'number') return Number.isFinite(value);
  if (typeof value !== 'object') return true;
  if (Array.isArray(value)) return value.length > 0 && value.every(isKnown);
  if ('number' in value) return Number.isFinite(value.number);
  return value.with?.of !== 0 && Object.values(value.with ?? {}).every(isKnown);
}

/** @param {Language} language @param {Value} value @returns {string | number} */
function written(language, value) {
  if (typeof value !== 'object') return value;
  if (Array.isArray(value)) return new Intl.ListFormat(language).format(value.map((part) => sentence(language, part)));
  if ('say' in value) return sentence(language, value);
  const { number, digits } = value;
  return number
    .toLocaleString(language, { minimumFractionDigits: digits, maximumFractionDigits: digits })
    .replace('-', '−');
}

/** @param {Language} language @param {Said} said @returns {string} */
export const sentence = (language, { say, with: values = {} }) =>
  filled(
    kWords[language][say],
    Object.fromEntries(Object.entries(values).map(([key, value]) => [key, written(language, value)])),
    language,
  );
