// SPDX-License-Identifier: GPL-3.0-or-later
// What came out: numbers, whether it can be read, and the file.
import { byId, make } from './dom.js';
import { formatMm, formatNumber, formatSeconds } from './format.js';
import { showFindings } from './messages.js';

/** @typedef {import('../engine/types.js').Report} Report */

const kUnlinkedLength = 80;

export class ResultPanel {
  /** @param {{ onDownload: (format: string) => void, onSaveReport: () => void }} listener */
  constructor({ onDownload, onSaveReport }) {
    this.region_ = byId('result', HTMLElement);
    this.verdict_ = byId('verdict', HTMLElement);
    this.numbers_ = byId('numbers', HTMLElement);
    this.notes_ = byId('result-notes', HTMLElement);
    const format = byId('format', HTMLSelectElement);
    byId('download', HTMLButtonElement).addEventListener('click', () => onDownload(format.value));
    byId('save-report', HTMLButtonElement).addEventListener('click', onSaveReport);
  }

  /**
   * @param {Report} report
   * @param {string} readBack  what the page's reader read; '' if nothing
   * @param {number} elapsedMs  from the click to the end
   */
  show(report, readBack, elapsedMs) {
    const { size, depth, mesh, symbol } = report;
    const solid = mesh.closed && mesh.manifold && mesh.selfIntersections === 0;
    this.showVerdict_(report.text, readBack);
    this.numbers_.replaceChildren(
      ...row('Size', `${formatMm(size.symbolMm)}, modules of ${formatMm(size.moduleMm)}`),
      ...row('Depth', `${formatMm(depth.meanMm)} on average, ${formatMm(depth.maxMm)} at most`),
      ...row('Time', formatSeconds(elapsedMs)),
      ...row('Code', `version ${symbol.version}-${symbol.ecc}, ${symbol.modules} × ${symbol.modules} modules`),
      ...row('Solid', `${solid ? 'closed and manifold' : 'not a clean solid'}, ${formatNumber(mesh.triangles)} triangles`));
    showFindings(this.notes_, notes(report, solid));
    this.region_.classList.remove('outdated');
    this.region_.hidden = false;
  }

  /** The model or the settings have changed since. */
  markOutdated() {
    if (this.region_.hidden || this.region_.classList.contains('outdated')) return;
    this.region_.classList.add('outdated');
    this.notes_.prepend(make('li', { className: 'warning', text: 'Made before your last change. Engrave again to update it.' }));
  }

  hide() {
    this.region_.hidden = true;
  }

  scrollIntoView() {
    this.region_.scrollIntoView({ block: 'start' });
  }

  /** @param {string} text @param {string} readBack */
  showVerdict_(text, readBack) {
    const right = readBack === text;
    this.verdict_.classList.toggle('bad', !right);
    if (readBack === '') {
      this.verdict_.textContent = 'Could not be read back from its picture.';
    } else if (!right) {
      this.verdict_.textContent = `Reads as “${readBack}”, which is not the text that was asked for.`;
    } else {
      const link = /^https?:\/\/\S+$/.test(text) && text.length <= kUnlinkedLength;
      const words = link ? make('a', { text }) : make('q', { text });
      if (words instanceof HTMLAnchorElement) Object.assign(words, { href: text, target: '_blank', rel: 'noopener noreferrer' });
      this.verdict_.replaceChildren('Reads as ', words);
    }
  }
}

/** @param {string} term @param {string} value */
const row = (term, value) => [make('dt', { text: term }), make('dd', { text: value })];

/** @param {Report} report @param {boolean} solid */
function notes({ depth, verification }, solid) {
  const found = [];
  if (!solid) {
    found.push({ severity: 'warning', message: 'The result is not a clean solid', hint: 'A slicer may have to repair it' });
  }
  if (depth.limitedSubmodules > 0) {
    found.push({
      severity: 'note',
      message: `${depth.limitedSubmodules === 1 ? 'One submodule' : `${formatNumber(depth.limitedSubmodules)} submodules`} ` +
        'could not be carved as deep as wanted',
      hint: 'A larger code, a thicker wall or a smaller “Wall left” helps',
    });
  }
  for (const { problem, hint } of verification.printability) {
    found.push({ severity: 'warning', message: withoutTicks(problem), hint: withoutTicks(hint) });
  }
  return found;
}

/** Names of patterns stand between ticks in reports. @param {string} text */
const withoutTicks = (text) => text.replaceAll('`', '');
