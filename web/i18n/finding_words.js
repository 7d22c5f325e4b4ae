// SPDX-License-Identifier: GPL-3.0-or-later
// What was found in a model, in the page's words: the core's speak of the command's options.
import { textOr } from './catalogue.js';
import { coreWords } from './core_words.js';

/** @typedef {import('../engine/types.js').Finding} Finding */
/** @typedef {{ severity: Finding['severity'], message: string, hint: string }} FindingWords */

const kPlace = /\([-\d.e+]+, [-\d.e+]+, [-\d.e+]+\)/;
const kSize = /[-\d.e+]+ x [-\d.e+]+ x [-\d.e+]+ mm/;
const kLength = /[-\d.e+]+ mm/;

/** @param {Finding} finding @returns {FindingWords} */
export function findingWords({ severity, code, count, message, hint }) {
  const values = {
    count,
    at: kPlace.exec(message)?.[0] ?? '',
    size: (kSize.exec(message)?.[0] ?? '').replaceAll(' x ', ' × '),
    distance: kLength.exec(message)?.[0] ?? '',
  };
  const own = textOr('findings', code, '', values);
  return { severity, message: own || coreWords(message), hint: own ? textOr('findings', `${code}.hint`, '', values) : coreWords(hint) };
}

/**
 * Units that would give a tiny model a size that people print, as the core's hint lists them.
 * @param {Finding} finding
 * @returns {{ unit: string, size: string }[]}
 */
export function suggestedUnits({ code, hint }) {
  if (code !== 'tiny') return [];
  return [...hint.matchAll(/it is ([^:]+ mm): --units (\w+)/g)].map(([, size, unit]) => ({ unit, size: size.replaceAll(' x ', ' × ') }));
}
