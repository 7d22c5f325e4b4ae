// SPDX-License-Identifier: GPL-3.0-or-later
// The result: the verdict, the file and the numbers.
import { onLanguage, text } from '../i18n/catalogue.js';
import { byId, make } from '../dom/dom.js';
import { formatMm, formatSeconds } from '../i18n/format.js';
import { showMarkCost } from './carve_panel.js';
import { colourCostWithTower } from './colour_cost.js';
import { DownloadChoice } from './download_choice.js';
import { GradesPanel } from './grades_panel.js';
import { showFindings } from './messages.js';
import { markStep, showStep } from './steps.js';
import { isUnderWay, printingWords, tryingWords, verdictLines } from './verdict_lines.js';

/** @typedef {import('../engine/types.js').Report} Report */
/** @typedef {import('../engine/types.js').Verdict} Verdict */
/** @typedef {import('../engine/types.js').Remedy} Remedy */
/** @typedef {import('./grades_panel.js').ViewTrier} ViewTrier */
/**
 * @typedef {{ report: Report, only3mf: import('../engine/types.js').ModelInfo['only3mf'], elapsedMs: number,
 *   printed?: import('../engine/types.js').Printed, seen?: import('../engine/types.js').GreyImage }} Result  `only3mf`:
 *   of its model; `elapsedMs`: from the click to the end; `printed`: undefined until something is known about the print;
 *   `seen`: a phone's picture of it
 */

/**
 * @typedef {object} ResultListener
 * @property {(file: import('./download_choice.js').Download) => void} onDownload
 * @property {() => void} onSaveReport
 * @property {() => void} onSaveMaps
 * @property {() => void} onAnother  another code on the result
 * @property {(remedy: Remedy, label: string) => void} onRemedy
 * @property {(starts: boolean) => void} onPrint  start or stop the simulation of the print
 * @property {() => void} onTryPrints  try other print settings
 * @property {ViewTrier} onTryViews
 */

export class ResultPanel {
  constructor() {
    /** @type {ResultListener | undefined} */ this.listener_ = undefined;
    this.region_ = byId('result', HTMLElement);
    this.verdict_ = byId('verdict', HTMLElement);
    this.numbers_ = byId('numbers', HTMLElement);
    this.notes_ = byId('result-notes', HTMLElement);
    this.grades_ = new GradesPanel(async (...report) => this.listener_?.onTryViews(...report));
    /** @type {Result | undefined} */ this.result_ = undefined;
    this.outdated_ = false;
    this.explains_ = false; // a failed verdict shows its lines
    /** @type {import('../i18n/live.js').Words | undefined} */ this.attempt_ = undefined;
    this.choice_ = new DownloadChoice();
    this.again_ = byId('engrave-again', HTMLButtonElement);
    this.download_ = byId('download', HTMLButtonElement);
    this.downloadPrevious_ = byId('download-previous', HTMLButtonElement);
    for (const button of [this.download_, this.downloadPrevious_])
      button.addEventListener('click', () => this.listener_?.onDownload(this.choice_.chosen));
    /** @type {import('./verdict_lines.js').Listener} */ this.forLines_ = {
      onRemedy: (remedy, label) => this.listener_?.onRemedy(remedy, label),
      onPrint: (isOn) => this.listener_?.onPrint(isOn),
      onTryPrints: () => this.listener_?.onTryPrints(),
      onExplain: (isOpen) => (this.explains_ = isOpen),
    };
    byId('another-code', HTMLButtonElement).addEventListener('click', () => this.listener_?.onAnother());
    byId('save-report', HTMLButtonElement).addEventListener('click', () => this.listener_?.onSaveReport());
    byId('save-maps', HTMLButtonElement).addEventListener('click', () => this.listener_?.onSaveMaps());
    onLanguage(() => this.render_());
    this.render_();
  }

  /** @param {ResultListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /** @param {Result} result */
  show(result) {
    this.result_ = result;
    this.outdated_ = this.explains_ = false;
    this.grades_.show(result.report);
    this.choice_.offerFor(result.report.mark, result.only3mf);
    this.render_();
  }

  /** Shows new facts about the current result. */
  update() {
    const { printed } = this.result_ ?? {};
    const heading = this.verdict_.querySelector('.printing'),
      trying = this.verdict_.querySelector('.trying-prints');
    const trials = printed?.state === 'made' ? printed.trials : undefined;
    const isSameTrial =
      trials?.fraction !== undefined &&
      this.verdict_.querySelectorAll('.print-trials li').length === trials.tried.length;
    // Change only the words where possible: replacing a button under the pointer would lose a click.
    if (heading && isUnderWay(printed)) heading.textContent = printingWords(printed);
    else if (trying && isSameTrial) trying.textContent = tryingWords(trials);
    else this.render_();
  }

  /** @param {boolean} outdated  the model or the settings have changed since the result */
  setOutdated(outdated) {
    if (outdated === this.outdated_) return;
    this.outdated_ = outdated;
    this.render_();
  }

  /** @param {import('../i18n/live.js').Words} [attempt]  at a better result, which is under way; none: the result is final */
  setAttempt(attempt) {
    if (attempt === this.attempt_) return;
    this.attempt_ = attempt;
    this.render_();
  }

  hide() {
    this.result_ = undefined;
    this.outdated_ = false;
    this.grades_.hide();
    this.render_();
  }

  /** Scrolls to the verdict and moves the focus there, for screen readers. */
  reveal() {
    byId('step-check', HTMLElement).scrollIntoView({ block: 'start' });
    const at = document.activeElement;
    const isWaiting = at === null || at === document.body || at.closest('.actions') !== null;
    if (isWaiting) byId('check-heading', HTMLElement).focus({ preventScroll: true }); // otherwise the user is busy
  }

  render_() {
    this.region_.hidden = !this.result_;
    this.again_.hidden = this.downloadPrevious_.hidden = !this.outdated_;
    this.download_.hidden = this.outdated_;
    markStep('carve', this.result_ && !this.outdated_ ? 'done' : 'open');
    showMarkCost(this.outdated_ ? undefined : this.result_?.report);
    if (!this.result_) {
      showStep('check', 'open', () => text('page.checkNone'));
      return;
    }
    const { report, elapsedMs, printed } = this.result_;
    const { size, symbol } = report;
    byId('grades', HTMLElement).hidden = byId('save-maps', HTMLElement).hidden = symbol === null;
    const { verdict } = report.verification;
    if (this.outdated_) showStep('check', 'open', () => text('page.checkOutdated'));
    else if (this.attempt_) showStep('check', 'warn', this.attempt_);
    else if (isUnderWay(printed) && isGoodButForPrinting(verdict))
      showStep('check', 'done', () => text('check.stepPrinting'));
    else showStep('check', kMarks[worstOf(verdict)], () => text(symbol ? summaryOf(verdict) : summaryOfText(verdict)));
    this.region_.classList.toggle('outdated', this.outdated_);
    showFindings(this.notes_, this.findings_());
    // While an attempt is made, the module answers no questions about this result.
    this.verdict_.inert = byId('grades', HTMLElement).inert = this.attempt_ !== undefined;
    this.verdict_.replaceChildren(...verdictLines(this.result_, this.forLines_, this.explains_));
    this.numbers_.replaceChildren(
      ...row(
        text('page.size'),
        size.moduleMm === null
          ? formatMm(size.symbolMm)
          : text('page.sizeValue', { width: formatMm(size.symbolMm), module: formatMm(size.moduleMm) }),
      ),
      ...(symbol ? [] : row(text('page.capitals'), formatMm(report.label?.capitalMm ?? 0))),
      ...depthRow(report),
      ...(report.mark === 'shadow' ? [] : row(text('page.secondColour'), colourCostWithTower(report.colour))),
      ...row(text('page.time'), formatSeconds(elapsedMs)),
      ...(symbol ? row(text('page.code'), text('page.codeValue', symbol)) : []),
    );
  }

  /** @returns {import('./messages.js').Shown[]} */
  findings_() {
    const attempt = this.attempt_;
    return [
      ...(this.outdated_ ? [{ severity: 'warning', found: text('page.outdated'), help: '' }] : []),
      ...(attempt ? [{ severity: 'note', found: attempt(), help: text('page.soFar') }] : []),
    ];
  }
}

const kMarks = /** @type {const} */ ({ good: 'done', barely: 'warn', bad: 'bad' });

/** @param {Verdict} verdict */
function worstOf({ reads, prints, solid }) {
  const levels = [reads.level, prints.level, solid.level];
  return levels.includes('bad') ? 'bad' : levels.includes('barely') ? 'barely' : 'good';
}

/** @param {Verdict} verdict */
const isGoodButForPrinting = ({ reads, solid }) => reads.level === 'good' && solid.level === 'good';

/** @param {Verdict} verdict */
function summaryOf({ reads, prints, solid }) {
  if (reads.level === 'bad') return 'check.stepUnread';
  if (!solid.passed) return 'check.stepNotSolid';
  if (reads.level === 'barely') return 'check.stepBarely';
  if (prints.level !== 'good') return 'check.stepUnprintable';
  return solid.level === 'good' ? 'check.stepGood' : 'check.stepCrossing';
}

/** @param {Verdict} verdict */
function summaryOfText({ reads, prints, solid }) {
  if (!prints.passed) return 'check.textUnprintable';
  if (!solid.passed) return 'check.textNotSolid';
  if (reads.level !== 'good') return 'check.textSmall';
  return prints.level === 'good' ? 'check.textGood' : 'check.textBarelyPrints';
}

/** @param {Report} report */
function depthRow({ content, mark, depth }) {
  if (mark === 'paint') return [];
  const max = formatMm(depth.maxMm);
  return row(
    text('page.depth'),
    mark === 'inlay' || content === 'text' ? max : text('page.depthValue', { mean: formatMm(depth.meanMm), max }),
  );
}

/** @param {string} term @param {string} value */
const row = (term, value) => [make('dt', { text: term }), make('dd', { text: value })];
