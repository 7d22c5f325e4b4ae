// SPDX-License-Identifier: GPL-3.0-or-later
// All texts of the app in all languages. The texts of each part of the page are in parts/, all languages side by side.
// An article adds its own texts.
import { recall, remember } from '../storage/remembered.js';
import { kLanguages } from './languages.js';
import { batch } from './parts/batch.js';
import { check } from './parts/check.js';
import { code } from './parts/code.js';
import { help } from './parts/help.js';
import { inspector } from './parts/inspector.js';
import { autosave } from './parts/autosave.js';
import { links } from './parts/links.js';
import { page } from './parts/page.js';
import { samples } from './parts/samples.js';
import { settings } from './parts/settings.js';
import { exports } from './parts/exports.js';
import { view } from './parts/view.js';

/** @typedef {import('./languages.js').Language} Language */
/**
 * @typedef {string | { one: string, other: string }} Entry  the value `count` selects the form; `{name}` stands for a
 *   value
 */

const kParts = { batch, check, code, help, inspector, autosave, links, page, samples, settings, exports, view };

/**
 * @typedef {{ guide: typeof import('./parts/guide.js').guide, method: typeof import('./parts/method.js').method,
 *   gallery: typeof import('./parts/gallery.js').gallery,
 *   study: typeof import('./parts/study.js').study, figures: typeof import('./parts/figures.js').figures }} Articles
 */
/** @typedef {typeof kParts & Articles} Parts */
/** @typedef {{ [P in keyof Parts]: `${P}.${string & keyof Parts[P]['en']}` }[keyof Parts]} Key */

/** @param {Partial<Articles>} articles  articles whose texts `text` will find from now on */
export const addTexts = (articles) => void Object.assign(kParts, articles);

const kStored = 'language';

/** @param {unknown} value @returns {value is Language} */
const isLanguage = (value) => kLanguages.includes(/** @type {Language} */ (value));

/**
 * Returns the language named in the address, else the stored choice, else the first of the browser's languages that we
 * have.
 */
function preferredLanguage() {
  if (typeof document === 'undefined') return 'en';
  const preferred = [
    new URLSearchParams(location.search).get('lang'),
    recall(kStored),
    ...navigator.languages.map((tag) => tag.split('-')[0]),
  ];
  return preferred.find(isLanguage) ?? 'en';
}

/** @type {Language} */
let language = preferredLanguage();

export const currentLanguage = () => language;

/** @type {(() => void)[]} */
const listeners = [];

/**
 * @param {() => void} listener  writes its texts again after the language has changed or the words of a message have
 *   loaded
 */
export function onLanguage(listener) {
  listeners.push(listener);
}

/** Stores the language for the next visit and has all texts on the page written again. @param {Language} chosen */
export function setLanguage(chosen) {
  language = chosen;
  remember(kStored, chosen);
  writeAgain();
}

export const writeAgain = () => listeners.forEach((listener) => listener());

/** @param {Language} of @param {string} key @returns {Entry | undefined} */
function entry(of, key) {
  const dot = key.indexOf('.');
  return /** @type {any} */ (kParts)[key.slice(0, dot)]?.[of]?.[key.slice(dot + 1)];
}

/**
 * @param {Key} key
 * @param {Record<string, string | number>} [values]
 * @throws {Error} if the key or a value is missing
 */
export const text = (key, values = {}) => textIn(language, key, values);

/**
 * Returns a text like `text`, but in any language.
 * @param {Language} of
 * @param {Key} key
 * @param {Record<string, string | number>} [values]
 */
export function textIn(of, key, values = {}) {
  const words = entry(of, key);
  if (words === undefined) throw new Error(`There is no text "${key}" in "${of}"`);
  const template =
    typeof words === 'string'
      ? words
      : words[new Intl.PluralRules(of).select(Number(values.count)) === 'one' ? 'one' : 'other'];
  return template.replace(/\{(\w+)\}/g, (_, name) => {
    const value = values[name];
    if (value === undefined) throw new Error(`The text "${key}" lacks the value "${name}"`);
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
 * @param {keyof typeof kParts} part
 * @param {string} name
 * @param {string} [otherwise]
 * @param {Record<string, string | number>} [values]
 */
export const textOr = (part, name, otherwise = name, values = {}) =>
  entry(language, `${part}.${name}`) === undefined ? otherwise : text(/** @type {Key} */ (`${part}.${name}`), values);

/** Returns every loaded part, for tests. */
export const allParts = () => kParts;
