// SPDX-License-Identifier: GPL-3.0-or-later
// All parts of a batch: starting them, their progress and their download.
import { onLanguage, text } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { setDisabled } from '../dom/set_disabled.js';
import { byId } from '../dom/dom.js';
import { PartsTable } from './parts_table.js';
import { showStep } from './steps.js';

/** @typedef {Pick<import('../batch/tracker.js').Tracker, 'state'>} Tracker */

/**
 * State before the batch is started: the number of parts, and whether the first part was carved and passed.
 * @typedef {{ count: number, first: 'none' | 'bad' | 'good' }} Begin
 * @typedef {'starting' | 'carving' | 'pausing' | 'paused' | 'stopped' | 'over'} Phase
 * @typedef {{ tracker: Tracker, rows: number, state: import('../engine/types.js').BatchState, phase: Phase }} Progress
 */

const kTableMs = 500; // least time between two updates of the table, so that it stays readable

/**
 * @typedef {object} PartsListener
 * @property {(printEvery: number, atMost: number) => void} onBegin  `atMost`: parts to make; Infinity: all
 * @property {() => void} onPause
 * @property {() => void} onResume  or continues a stopped batch
 * @property {() => void} onStop
 * @property {() => void} onRetry
 * @property {() => void} onDownload
 * @property {() => void} onDiscard
 * @property {(index: number) => Promise<import('../engine/types.js').BatchRowName | undefined>} nameOf
 */

export class PartsPanel {
  constructor() {
    /** @type {PartsListener | undefined} */ this.listener_ = undefined;
    this.how_ = byId('parts-how', HTMLElement);
    this.firstOnly_ = byId('parts-first', HTMLInputElement);
    this.every_ = byId('print-every', HTMLInputElement);
    this.begin_ = byId('carve-all', HTMLButtonElement);
    this.pause_ = byId('parts-pause', HTMLButtonElement);
    this.resume_ = byId('parts-resume', HTMLButtonElement);
    this.stop_ = byId('parts-stop', HTMLButtonElement);
    this.retry_ = byId('parts-retry', HTMLButtonElement);
    this.download_ = byId('parts-download', HTMLButtonElement);
    this.discard_ = byId('parts-discard', HTMLButtonElement);
    this.progress_ = byId('parts-progress', HTMLProgressElement);
    this.table_ = new PartsTable(byId('parts-table', HTMLElement), async (index) => this.listener_?.nameOf(index));
    /** @type {Tracker | undefined} */ this.tracker_ = undefined;
    /** @type {ReturnType<typeof setTimeout> | undefined} */ this.tableTimer_ = undefined;
    this.isSaving_ = false;
    /** @type {() => void} */ this.renew_ = () => {};
    this.begin_.addEventListener('click', () => {
      if (this.firstOnly_.reportValidity() && this.every_.reportValidity())
        this.listener_?.onBegin(this.every_.valueAsNumber, this.atMost_);
    });
    for (const field of [this.firstOnly_, this.every_])
      field.addEventListener('keydown', (event) => {
        if (event.key === 'Enter') event.preventDefault(); // otherwise Enter would engrave the first part
      });
    this.firstOnly_.addEventListener('input', () => this.renew_());
    for (const [button, act] of /** @type {const} */ ([
      [this.pause_, 'onPause'],
      [this.resume_, 'onResume'],
      [this.stop_, 'onStop'],
      [this.retry_, 'onRetry'],
      [this.download_, 'onDownload'],
      [this.discard_, 'onDiscard'],
    ]))
      button.addEventListener('click', () => this.listener_?.[act]());
    setDisabled(this.begin_, 'batch.listMissing');
    setDisabled(this.download_, 'batch.whyNoneDone');
    onLanguage(() => this.renew_());
  }

  /** @param {PartsListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /** Number of parts to make at most. */
  get atMost_() {
    return this.firstOnly_.value && this.firstOnly_.validity.valid ? this.firstOnly_.valueAsNumber : Infinity;
  }

  /** Shows that no part has been carved yet. @param {Begin} begin */
  showBegin({ count, first }) {
    this.renew_ = () => this.showBegin({ count, first });
    byId('parts-begin', HTMLElement).hidden = false;
    byId('parts-run', HTMLElement).hidden = true;
    const whyNot = /** @type {const} */ ({ none: 'batch.askForFirst', bad: 'batch.firstDoesNotPass', good: undefined });
    setDisabled(this.begin_, count === 0 ? 'batch.listMissing' : whyNot[first]);
    const { atMost_: atMost } = this;
    this.begin_.textContent =
      atMost < count ? text('batch.carveFirst', { count: atMost }) : text('batch.carveAll', { count });
    write(this.how_, () =>
      text(first === 'good' ? 'batch.ready' : first === 'bad' ? 'batch.firstDoesNotPass' : 'batch.askForFirst'),
    );
    this.how_.hidden = false;
    showStep('parts', 'open', () => (count === 0 ? '' : text('batch.state', { count, finished: 0 })));
  }

  /** @param {Progress} progress */
  showProgress({ tracker, rows: count, state, phase }) {
    this.renew_ = () => this.showProgress({ tracker, rows: count, state, phase });
    const { finished, failed: failures, done, remainingMs } = state;
    const isUnderWay = phase === 'starting' || phase === 'carving' || phase === 'pausing';
    byId('parts-begin', HTMLElement).hidden = true;
    byId('parts-run', HTMLElement).hidden = false;
    this.how_.hidden = true;
    this.progress_.max = count;
    this.progress_.hidden = phase === 'over';
    const focused = document.activeElement;
    this.pause_.hidden = !isUnderWay;
    setDisabled(this.pause_, phase === 'pausing' ? 'batch.whyPausing' : undefined);
    this.resume_.hidden = phase !== 'paused' && phase !== 'stopped';
    this.stop_.hidden = phase === 'stopped' || phase === 'over';
    this.retry_.hidden = !(phase === 'over' || phase === 'stopped') || failures === 0;
    this.download_.textContent = downloadWords({ done, count });
    setDisabled(this.download_, done === 0 ? 'batch.whyNoneDone' : this.isSaving_ ? 'batch.whySaving' : undefined);
    if (focused instanceof HTMLElement && focused.hidden)
      [this.resume_, this.pause_, this.download_].find(({ hidden }) => !hidden)?.focus();
    const failed = failures > 0 ? text('batch.failedCount', { count: failures }) : '';
    const left =
      phase === 'carving' && remainingMs !== null ? text('batch.left', { time: durationOf(remainingMs) }) : '';
    const words =
      phase === 'over'
        ? overWords({ done, failed: failures })
        : [phase === 'pausing' ? text('batch.pausing') : text(`batch.${phase}`, { count, finished }), failed, left]
            .filter(Boolean)
            .join('; ');
    showStep('parts', phase !== 'over' ? 'open' : failures > 0 ? 'warn' : 'done', () => words);
    this.showTable_(tracker, count);
  }

  /** Moves the bar. @param {number} rows  carved ones, with the carved part of those under way */
  showCarved(rows) {
    this.progress_.value = rows;
  }

  /** @param {boolean} isSaving  the ZIP is being written */
  setSaving(isSaving) {
    this.isSaving_ = isSaving;
    this.renew_();
  }

  /** Scrolls to the parts and moves the focus there. */
  reveal() {
    byId('step-parts', HTMLElement).scrollIntoView({ block: 'start' });
    byId('parts-heading', HTMLElement).focus({ preventScroll: true });
  }

  /** @param {Tracker} tracker @param {number} rows */
  showTable_(tracker, rows) {
    if (tracker !== this.tracker_) {
      this.tracker_ = tracker;
      this.table_.show(tracker, rows);
      return;
    }
    this.tableTimer_ ??= setTimeout(() => {
      this.tableTimer_ = undefined;
      void this.table_.update();
    }, kTableMs);
  }
}

/** Says how many parts a finished batch has made. @param {{ done: number, failed: number }} parts */
export const overWords = ({ done, failed }) =>
  failed > 0 ? text('batch.overFailed', { done, failed }) : text('batch.over', { count: done });

/** Names the download, so that nobody takes some of the parts for all. @param {{ done: number, count: number }} parts */
export const downloadWords = ({ done, count }) =>
  0 < done && done < count ? text('batch.downloadSome', { done, count }) : text('batch.download');

/** Returns a duration in everyday words: 40 seconds, 12 minutes, 3 hours. @param {number} ms */
export function durationOf(ms) {
  const seconds = Math.max(1, Math.round(ms / 1000));
  if (seconds < 90) return text('batch.seconds', { count: seconds < 20 ? seconds : Math.round(seconds / 10) * 10 });
  if (seconds < 90 * 60) return text('batch.minutes', { count: Math.round(seconds / 60) });
  return text('batch.hours', { count: Math.round(seconds / 3600) });
}
