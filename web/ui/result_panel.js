// SPDX-License-Identifier: GPL-3.0-or-later
// What came out: numbers, whether it can be read, and the file.
import { onLanguage, text } from '../text/catalogue.js';
import { coreWords } from '../text/core_words.js';
import { byId, make } from './dom.js';
import { formatMm, formatNumber, formatSeconds } from './format.js';
import { showFindings } from './messages.js';
import { markStep, showStep } from './steps.js';

/** @typedef {import('../engine/types.js').Report} Report */
/** @typedef {{ report: Report, readBack: string, elapsedMs: number }} Result
 *   `readBack`: what the page's reader read, '' if nothing; `elapsedMs`: from the click to the end */

const kUnlinkedLength = 80;

export class ResultPanel {
  /** @param {{ onDownload: (format: string) => void, onSaveReport: () => void }} listener */
  constructor({ onDownload, onSaveReport }) {
    this.region_ = byId('result', HTMLElement);
    this.verdict_ = byId('verdict', HTMLElement);
    this.numbers_ = byId('numbers', HTMLElement);
    this.notes_ = byId('result-notes', HTMLElement);
    /** @type {Result | undefined} */ this.result_ = undefined;
    this.outdated_ = false;
    const format = byId('format', HTMLSelectElement);
    byId('download', HTMLButtonElement).addEventListener('click', () => onDownload(format.value));
    byId('save-report', HTMLButtonElement).addEventListener('click', onSaveReport);
    onLanguage(() => this.render_());
    this.render_();
  }

  /** @param {Result} result */
  show(result) {
    this.result_ = result;
    this.outdated_ = false;
    this.render_();
  }

  /** @param {boolean} outdated  the model or the settings have changed since */
  setOutdated(outdated) {
    if (outdated === this.outdated_) return;
    this.outdated_ = outdated;
    this.render_();
  }

  hide() {
    this.result_ = undefined;
    this.render_();
  }

  scrollIntoView() {
    byId('step-check', HTMLElement).scrollIntoView({ block: 'start' });
  }

  render_() {
    this.region_.hidden = !this.result_;
    markStep('carve', this.result_ && !this.outdated_ ? 'done' : 'todo');
    if (!this.result_) return showStep('check', 'todo', () => text('page.checkNone'));
    const { report, readBack, elapsedMs } = this.result_;
    const { size, depth, mesh, symbol } = report;
    const solid = mesh.closed && mesh.manifold && mesh.selfIntersections === 0;
    const good = solid && readBack === report.text;
    showStep('check', this.outdated_ ? 'todo' : good ? 'done' : 'bad', () => text(this.outdated_ ? 'page.checkOutdated' : 'page.checkDone'));
    this.region_.classList.toggle('outdated', this.outdated_);
    this.showVerdict_(report.text, readBack);
    this.numbers_.replaceChildren(
      ...row(text('page.size'), text('page.sizeValue', { width: formatMm(size.symbolMm), module: formatMm(size.moduleMm) })),
      ...row(text('page.depth'), text('page.depthValue', { mean: formatMm(depth.meanMm), max: formatMm(depth.maxMm) })),
      ...row(text('page.time'), formatSeconds(elapsedMs)),
      ...row(text('page.code'), text('page.codeValue', symbol)),
      ...row(text('page.solid'), text(solid ? 'page.solidYes' : 'page.solidNo', { triangles: formatNumber(mesh.triangles) })));
    showFindings(this.notes_, notes(report, solid, this.outdated_));
  }

  /** @param {string} wanted @param {string} readBack */
  showVerdict_(wanted, readBack) {
    const right = readBack === wanted;
    this.verdict_.classList.toggle('bad', !right);
    if (readBack === '') {
      this.verdict_.textContent = text('page.readsNot');
    } else if (!right) {
      this.verdict_.textContent = text('page.readsWrong', { text: readBack });
    } else {
      const link = /^https?:\/\/\S+$/.test(wanted) && wanted.length <= kUnlinkedLength;
      const words = link ? make('a', { text: wanted }) : make('q', { text: wanted });
      if (words instanceof HTMLAnchorElement) Object.assign(words, { href: wanted, target: '_blank', rel: 'noopener noreferrer' });
      this.verdict_.replaceChildren(text('page.readsAs'), words);
    }
  }
}

/** @param {string} term @param {string} value */
const row = (term, value) => [make('dt', { text: term }), make('dd', { text: value })];

/** @param {Report} report @param {boolean} solid @param {boolean} outdated */
function notes({ depth, verification }, solid, outdated) {
  const found = [];
  if (outdated) found.push({ severity: 'warning', message: text('page.outdated'), hint: '' });
  if (!solid) found.push({ severity: 'warning', message: text('page.notSolid'), hint: text('page.notSolidHint') });
  if (depth.limitedSubmodules > 0) {
    found.push({ severity: 'note', message: text('page.limited', { count: depth.limitedSubmodules }), hint: text('page.limitedHint') });
  }
  for (const { problem, hint } of verification.printability) {
    found.push({ severity: 'warning', message: coreWords(problem), hint: coreWords(hint) });
  }
  return found;
}
