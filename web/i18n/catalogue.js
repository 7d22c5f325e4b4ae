// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the page in the chosen language. English is always there; other languages, and the texts of articles, are
// loaded (locales.js).
import { recall, remember } from '../storage/remembered.js';
import { kEnglish, kLanguages, load } from './locales.js';
import { withUnitsKept } from './units.js';

/** @typedef {typeof import('../../locales/en.json')} English */
/** @typedef {Pick<English, 'format' | 'page' | 'settings'>} AppTexts */
/** @typedef {keyof English['articles']} Article */
/** @typedef {English['page'] & English['articles']} Groups */
/** @typedef {{ [G in keyof Groups]: `${G}.${string & keyof Groups[G]}` }[keyof Groups]} Key */
/**
 * @typedef {string | { one: string, other: string }} Entry  the value `count` selects the form; `{name}` stands for a
 *   value
 */

const kStored = 'language';

/** The texts that are loaded: languages, then parts. @type {Map<string, Map<string, any>>} */
const loaded = new Map([['en', new Map([['app', kEnglish]])]]);
/** The parts that the page shows. @type {Set<import('./locales.js').Part>} */
const shown = new Set(['app']);
let language = 'en';
let asked = language;

/** @type {(() => void)[]} */
const listeners = [];

/** Returns the code of the language in which texts are: "de". */
export const currentLanguage = () => language;

/** Returns the app's texts in the current language. @returns {AppTexts} */
export const appTexts = () => loaded.get(language)?.get('app');

/**
 * Loads the texts of articles, in the language named in the address, else in the stored one, else in the first of the
 * browser's languages that we have. Without a network they stay in English.
 * @param {Article[]} articles
 */
export async function startTexts(...articles) {
  for (const article of articles) shown.add(article);
  await use('en');
  await use(preferredLanguage()).catch(() => {});
}

/** Returns the languages that have texts for all that the page shows. */
export const offeredLanguages = () => kLanguages.filter(({ hasArticles }) => hasArticles || shown.size === 1);

function preferredLanguage() {
  if (typeof document === 'undefined') return 'en';
  const preferred = [
    new URLSearchParams(location.search).get('lang'),
    recall(kStored),
    ...navigator.languages.map((tag) => tag.split('-')[0]),
  ];
  return preferred.find((one) => offeredLanguages().some(({ code }) => code === one)) ?? 'en';
}

/** Loads a language, and has texts in it from then on, unless another was asked for meanwhile. @param {string} chosen */
async function use(chosen) {
  asked = chosen;
  const parts = loaded.get(chosen) ?? new Map();
  await Promise.all(
    [...shown].map(async (part) => {
      if (!parts.has(part)) parts.set(part, await load(chosen, part));
    }),
  );
  loaded.set(chosen, parts);
  if (asked === chosen) language = chosen;
}

/**
 * @param {() => void} listener  writes its texts again after the language has changed or the words of a message have
 *   loaded
 */
export function onLanguage(listener) {
  listeners.push(listener);
}

/**
 * Loads a language, stores it for the next visit, and has all texts on the page written again.
 * @param {string} chosen
 * @throws {Error} if it cannot be loaded; the language stays
 */
export async function setLanguage(chosen) {
  await use(chosen);
  if (language !== chosen) return;
  remember(kStored, chosen);
  writeAgain();
}

export const writeAgain = () => listeners.forEach((listener) => listener());

/** @param {string} key @returns {Entry | undefined} */
function entry(key) {
  const [group, name] = key.split(/\.(.*)/);
  const texts = /** @type {any} */ (appTexts().page)[group] ?? loaded.get(language)?.get(group);
  return texts?.[name];
}

/**
 * @param {Key} key
 * @param {Record<string, string | number>} [values]
 * @throws {Error} if the key or a value is missing
 */
export function text(key, values = {}) {
  const words = entry(key);
  if (words === undefined) throw new Error(`There is no text "${key}" in "${language}"`);
  return filled(words, values, language);
}

/**
 * Puts values into a text.
 * @param {Entry} words
 * @param {Record<string, string | number>} values
 * @param {string} of  the language
 * @throws {Error} if a value is missing
 */
export function filled(words, values, of) {
  const template =
    typeof words === 'string'
      ? words
      : words[new Intl.PluralRules(of).select(Number(values.count)) === 'one' ? 'one' : 'other'];
  return withUnitsKept(template).replace(/\{(\w+)\}/g, (_, name) => {
    const value = values[name];
    if (value === undefined) throw new Error(`The text "${template}" lacks the value "${name}"`);
    return typeof value === 'number' ? value.toLocaleString(of) : value;
  });
}

/**
 * Writes texts where the markup names them: `data-text="page.model"` for the content, `data-text-label` for aria-label,
 * and `data-text-placeholder`, `data-text-title`, `data-text-alt` and `data-text-content` for these attributes.
 * @param {ParentNode} root
 */
export function localise(root) {
  const attributes = {
    textLabel: 'aria-label',
    textPlaceholder: 'placeholder',
    textTitle: 'title',
    textAlt: 'alt',
    textContent: 'content',
  };
  for (const element of root.querySelectorAll(
    '[data-text],[data-text-label],[data-text-placeholder],[data-text-title],[data-text-alt],[data-text-content]',
  )) {
    if (!(element instanceof HTMLElement || element instanceof SVGElement)) continue;
    if (element.dataset.text) element.textContent = text(/** @type {Key} */ (element.dataset.text));
    for (const [from, to] of Object.entries(attributes)) {
      const key = element.dataset[from];
      if (key) element.setAttribute(to, text(/** @type {Key} */ (key)));
    }
  }
}

/**
 * Returns the text for a name from the core or from a list of samples, or `otherwise` if the name is unknown.
 * @param {keyof Groups} group
 * @param {string} name
 * @param {string} [otherwise]
 * @param {Record<string, string | number>} [values]
 */
export const textOr = (group, name, otherwise = name, values = {}) => {
  const words = entry(`${group}.${name}`);
  return words === undefined ? otherwise : filled(words, values, language);
};
