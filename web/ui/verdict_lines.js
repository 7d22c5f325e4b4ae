// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict in three lines, each with its reason and what one click would change.
import { printingRemedies, readingRemedies } from '../verdict/remedies.js';
import { text } from '../i18n/catalogue.js';
import { asSentence, hintOf, sentenceOf } from '../i18n/messages.js';
import { make } from '../dom/dom.js';
import { formatMm, formatNumber, formatPercent, formatPlain } from '../i18n/format.js';
import { remedyButtons } from './messages.js';

/** @typedef {import('../engine/types.js').Report} Report */
/** @typedef {import('../verdict/verdict.js').Level} Level */
/** @typedef {import('../verdict/remedies.js').Remedy} Remedy */
/** @typedef {import('./settings_form.js').Values} Values */
/** @typedef {(remedy: Remedy, label: string) => void} OnRemedy */

const kUnlinkedLength = 80;

/**
 * @param {Report} report
 * @param {import('../decoder/reader.js').Reading} reading
 * @param {import('../verdict/verdict.js').Verdict} verdict
 * @param {Values} values  of the controls when it was carved
 * @param {OnRemedy} onRemedy
 */
export function verdictLines(report, reading, verdict, values, onRemedy) {
  const { verification, mesh, depth } = report;
  const nozzle = `${formatPlain(Number(values.nozzle))} mm`;
  const { features } = depth;
  const remedies = (/** @type {Level} */ level, /** @type {Remedy[]} */ found) => (level === 'good' ? [] : found);
  const triangles = formatNumber(mesh.triangles);
  return [
    line(verdict.reads, readsHeading(report.text, reading.text, verdict.reads), readingReasons(report, reading, verdict),
      remedies(verdict.reads, readingRemedies(report, values)), onRemedy),
    line(verdict.prints, [text(verdict.prints === 'good' ? 'check.prints' : 'check.printsNot', { nozzle })],
      verdict.prints === 'good'
        ? [text('check.printsReason', { pocket: formatMm(features.pocketMm), layers: formatNumber(Math.floor(features.leastDepthLayers + 1e-9)) })]
        : verification.printability.flatMap((problem) => [sentenceOf(problem), hintOf(problem)]).filter(Boolean),
      remedies(verdict.prints, printingRemedies(report, values)), onRemedy),
    line(verdict.solid, [text(verdict.solid === 'good' ? 'check.solid' : 'check.solidNot')],
      [verdict.solid === 'good' ? text('check.solidReason', { triangles }) : text('check.solidNotReason')],
      remedies(verdict.solid, [{ kind: 'spot' }]), onRemedy),
  ];
}

/**
 * @param {Level} level
 * @param {(Node | string)[]} heading
 * @param {string[]} reasons
 * @param {Remedy[]} remedies
 * @param {OnRemedy} onRemedy
 */
const line = (level, heading, reasons, remedies, onRemedy) => make('li', { className: level },
  make('strong', {}, ...heading),
  make('p', { text: reasons.map(asSentence).join(' ') }),
  ...remedyButtons(remedies.map((remedy) => {
    const label = remedyLabel(remedy);
    return { label, run: () => onRemedy(remedy, label) };
  })));

/** @param {string} wanted @param {string} found @param {Level} level */
function readsHeading(wanted, found, level) {
  if (found === '') return [text('check.readsNot')];
  if (level === 'bad') return [text('check.readsWrong', { text: found })];
  const link = /^https?:\/\/\S+$/.test(wanted) && wanted.length <= kUnlinkedLength;
  const words = link ? make('a', { text: wanted }) : make('q', { text: wanted });
  if (words instanceof HTMLAnchorElement) Object.assign(words, { href: wanted, target: '_blank', rel: 'noopener noreferrer' });
  return [text(level === 'good' ? 'check.readsAs' : 'check.barelyAs'), words];
}

/**
 * @param {Report} report
 * @param {import('../decoder/reader.js').Reading} reading
 * @param {import('../verdict/verdict.js').Verdict} verdict
 */
function readingReasons({ depth, verification }, reading, { reads, weak }) {
  const limited = depth.limitedSubmodules > 0 ? [text('check.limited', { count: depth.limitedSubmodules })] : [];
  if (reading.text === '') return [text('check.readsNotReason'), ...limited];
  const left = Math.max(0, verification.iso15415.unusedErrorCorrection.value);
  return [
    text('check.readsReason', { reads: reading.reads, tries: reading.tries }),
    text('check.correctionReason', { percent: formatPercent(left) }),
    ...(weak ? [text('check.failsGrade')] : []),
    ...(reads === 'good' ? [] : limited),
  ];
}

/** @param {Remedy} remedy */
function remedyLabel(remedy) {
  if (remedy.kind === 'spot') return text('check.spot');
  const size = `${formatPlain(Number(remedy.value))} mm`;
  if (remedy.kind === 'larger') return text('check.larger', { size });
  if (remedy.kind === 'nozzle') return text('check.nozzle', { nozzle: size });
  if (remedy.kind === 'layer') return text('check.layer', { layer: size });
  if (remedy.kind === 'pattern') return text('check.pattern', { pattern: shownValue(remedy.control, remedy.value) });
  return text(`check.${remedy.kind}`);
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
