// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict in three lines, each with its reasons and what one click would change.
import { text } from '../i18n/catalogue.js';
import { asSentence, hintOf, sentenceOf } from '../i18n/messages.js';
import { make } from '../dom/dom.js';
import { formatPlain } from '../i18n/format.js';
import { remedyButtons } from './messages.js';

/** @typedef {import('../engine/types.js').Report} Report */
/** @typedef {import('../engine/types.js').Aspect} Aspect */
/** @typedef {import('../engine/types.js').Remedy} Remedy */
/** @typedef {(remedy: Remedy, label: string) => void} OnRemedy */

const kUnlinkedLength = 80;

/** @param {Report} report @param {OnRemedy} onRemedy */
export function verdictLines({ text: wanted, verification: { verdict } }, onRemedy) {
  return [
    line(verdict.reads, readsHeading(wanted, verdict.reads), onRemedy),
    line(verdict.prints, [sentenceOf(verdict.prints.summary)], onRemedy),
    line(verdict.solid, [sentenceOf(verdict.solid.summary)], onRemedy),
  ];
}

/** @param {Aspect} aspect @param {(Node | string)[]} heading @param {OnRemedy} onRemedy */
const line = ({ level, reasons, remedies }, heading, onRemedy) => make('li', { className: level },
  make('strong', {}, ...heading),
  make('p', { text: reasons.flatMap((reason) => [sentenceOf(reason), hintOf(reason)]).filter(Boolean).map(asSentence).join(' ') }),
  ...remedyButtons(remedies.map((remedy) => {
    const label = sentenceOf(remedy);
    return { label, run: () => onRemedy(remedy, label) };
  })));

/** The summary, its text as a link where it is one. @param {string} wanted @param {Aspect} aspect */
function readsHeading(wanted, { summary }) {
  const { text: said } = summary.values;
  if (!said || !('term' in said) || said.term !== wanted) return [sentenceOf(summary)];
  const link = /^https?:\/\/\S+$/.test(wanted) && wanted.length <= kUnlinkedLength;
  const words = link ? make('a', { text: wanted }) : make('q', { text: wanted });
  if (words instanceof HTMLAnchorElement) Object.assign(words, { href: wanted, target: '_blank', rel: 'noopener noreferrer' });
  const kHere = '\u0000';
  const [before, after = ''] = sentenceOf({ ...summary, values: { text: { term: kHere } } }).split(kHere);
  return [before, words, after];
}

/** What a control would show of a value. @param {string} id @param {string} value */
export function shownValue(id, value) {
  const control = document.getElementById(id);
  if (control instanceof HTMLSelectElement) return [...control.options].find((option) => option.value === value)?.text ?? value;
  if (value === '') return text('settings.auto');
  return formatPlain(Number(value));
}

/** @param {string} id */
export const controlName = (id) => document.querySelector(`label[for="${id}"]`)?.textContent ?? id;
