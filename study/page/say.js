// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences about tables, in any language. The data select the sentences and fill in the values.
import { addTexts, textIn } from '../../web/i18n/catalogue.js';
import { figures } from '../../web/i18n/parts/figures.js';

/** @typedef {import('../../web/i18n/catalogue.js').Language} Language */
/** @typedef {keyof typeof figures.en} Word  key of web/i18n/parts/figures.js */
/** @typedef {{ say: Word, with?: Record<string, Value> }} Said */
/** A number with `digits` after the decimal point. @typedef {{ number: number, digits: number }} Measured */
/** @typedef {string | number | Measured | Said | Said[]} Value  an array becomes a list in words */

addTexts({ figures });

/** @param {Word} word @param {Record<string, Value>} [values] @returns {Said} */
export const said = (word, values) => (values ? { say: word, with: values } : { say: word });

/** @param {number} value @returns {Measured} */
export const mm = (value) => ({ number: value, digits: 2 });

/**
 * Returns the name of a table's value, such as `name('model', 'bunny')`. A value without a name stays as it is.
 * @param {string} kind
 * @param {string} value
 * @returns {Said}
 */
export function name(kind, value) {
  const word = /** @type {Word} */ (`${kind}-${value}`);
  return word in figures.en ? said(word) : said('asIs', { value });
}

/** Returns "on all 8 models" or "on 3 of 8 models". @param {import('./compare.js').Tally} tally @returns {Said} */
export const models = ({ holds, of }) => said(holds === of ? 'onAllModels' : holds === 0 ? 'onNoModel' : 'onSomeModels', { holds, of });

/** @param {import('./compare.js').Tally} tally @returns {Said} */
export const cases = ({ holds, of }) => said(holds === of ? 'inAllCases' : holds === 0 ? 'inNoCase' : 'inSomeCases', { holds, of });

/**
 * Tells whether the tables have all values of a sentence: every number is finite, and every count is out of at least
 * one.
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
  return number.toLocaleString(language, { minimumFractionDigits: digits, maximumFractionDigits: digits }).replace('-', '−');
}

/** @param {Language} language @param {Said} said @returns {string} */
export const sentence = (language, { say, with: values = {} }) => textIn(language, `figures.${say}`,
  Object.fromEntries(Object.entries(values).map(([key, value]) => [key, written(language, value)])));
