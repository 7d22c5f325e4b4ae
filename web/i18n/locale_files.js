// SPDX-License-Identifier: GPL-3.0-or-later
// Reads locales/, which has a file of texts for each language. A new file adds a language. Needs Node.
import { readFileSync, readdirSync } from 'node:fs';

/** @typedef {'app' | 'messages' | 'inspector' | 'guide' | 'method' | 'gallery' | 'study'} Part  the page loads each by itself */
/**
 * A language that the page offers.
 * @typedef {object} LanguageFile
 * @property {string} code  as in `<html lang>`: "de"
 * @property {string} name  in the language itself
 * @property {boolean} hasArticles  else they are in English
 */

const kFolder = new URL('../../locales/', import.meta.url);
const kOfCommand = new Set(['help', 'without', 'empty', 'command']); // words that only the command shows

/** @param {string} code */
const fileOf = (code) => JSON.parse(readFileSync(new URL(`${code}.json`, kFolder), 'utf8'));

/** Returns a language's name: "Français (traduction automatique)" until a speaker has read its texts. @param {any} file */
const nameIn = ({ language: { name, machineMade } }) => (machineMade ? `${name} (${machineMade})` : name);

/** The languages, English first. @type {readonly LanguageFile[]} */
export const kLanguageFiles = readdirSync(kFolder)
  .map((name) => name.replace(/\.json$/, ''))
  .sort((a, b) => Number(b === 'en') - Number(a === 'en') || a.localeCompare(b))
  .map((code) => ({ code, name: nameIn(fileOf(code)), hasArticles: 'articles' in fileOf(code) }));

/**
 * Returns a part of a language's texts, with English ones where it has none.
 * @param {string} code
 * @param {Part} part
 * @returns {any}
 */
export const partOf = (code, part) => complete(cut(fileOf(code), part), cut(fileOf('en'), part));

/** @param {any} file @param {Part} part @returns {any} */
function cut({ format, page, settings, messages, inspector, articles }, part) {
  const own = (/** @type {unknown} */ texts) =>
    JSON.parse(JSON.stringify(texts, (key, value) => (kOfCommand.has(key) ? undefined : value)));
  if (part === 'app') return { format, page, settings: own(settings) };
  if (part === 'messages') {
    const { command, ...ofPage } = messages;
    return own(Object.assign({}, ...Object.values(ofPage)));
  }
  if (part === 'inspector') return inspector ?? {};
  return articles?.[part];
}

/** @param {any} texts @param {any} english @returns {any} */
function complete(texts, english) {
  if (texts === undefined) return english;
  if (typeof texts !== 'object' || Array.isArray(texts) || 'other' in texts || english === undefined) return texts;
  const keys = new Set([...Object.keys(english), ...Object.keys(texts)]);
  return Object.fromEntries([...keys].map((key) => [key, complete(texts[key], english[key])]));
}
