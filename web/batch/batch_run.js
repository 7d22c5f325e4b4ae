// SPDX-License-Identifier: GPL-3.0-or-later
// Carves the rows that are still to be carved, by some engines side by side, each row by whichever is free.
import { describeThrown } from '../engine/engine_error.js';
import { isLost } from './row_engine.js';

/** @typedef {import('./row_engine.js').CarvedUnit} CarvedUnit */
/** @typedef {import('../engine/message.js').Message} Message */
/** @typedef {{ promise: Promise<void>, resolve: () => void }} Pause */
/** @typedef {Pick<import('./row_engine.js').RowEngine, 'start' | 'end' | 'carve'>} Engine */

const kMostLosses = 3;  // of engines without a row between them

/**
 * @typedef {object} BatchRunOptions
 * @property {import('./row_states.js').RowStates} states  of the rows, kept up to date
 * @property {() => Engine} makeEngine
 * @property {number} engines                 how many
 * @property {number} printEvery              whose print is looked at: each so many-th, from the first on
 * @property {number} perPlate                rows that share a file; 0: none do
 * @property {(carved: CarvedUnit) => Promise<string[]>} save  what is lost with the page otherwise; returns why each row failed, '' if it did not
 * @property {(indices: number[], why: Message) => Promise<string[]>} saveLost  the same of rows that engines are lost with
 * @property {() => void} onChange
 * @property {() => number} [now]  ms
 */

export class BatchRun {
  /** @param {BatchRunOptions} options */
  constructor({ states, makeEngine, engines, printEvery, perPlate, save, saveLost, onChange, now = () => performance.now() }) {
    this.states_ = states;
    this.makeEngine_ = makeEngine;
    this.engines_ = engines;
    this.printEvery_ = printEvery;
    this.perPlate_ = perPlate;
    this.save_ = save;
    this.saveLost_ = saveLost;
    this.onChange_ = onChange;
    this.now_ = now;
    /** @type {Set<Engine>} */ this.working_ = new Set();
    /** @type {Set<number>} */ this.lost_ = new Set();  // the first rows of units that an engine was lost with
    this.losses_ = 0;
    this.ended = false;
    /** @type {Pause | undefined} */ this.pause_ = undefined;
    /** What ended it before its rows were carved. @type {Message | undefined} */ this.problem = undefined;
    this.carved_ = 0;
    this.carvedMs_ = 0;
    this.since_ = now();
  }

  get paused() {
    return this.pause_ !== undefined;
  }

  /** Until the last row, at the pace so far; none before there is one. @returns {number | undefined}  ms */
  get remainingMs() {
    const { waiting, running } = this.states_.counts;
    if (this.carved_ === 0) return undefined;
    const workedMs = this.carvedMs_ + (this.paused ? 0 : this.now_() - this.since_);
    return (workedMs / this.carved_) * (waiting + running);
  }

  /** Until all rows are carved, or it is ended. */
  async run() {
    const engines = Math.max(1, Math.min(this.engines_, this.states_.counts.waiting));
    await Promise.all(Array.from({ length: engines }, () => this.work_()));
    this.end();
  }

  /** The rows that are being carved come to their end first. */
  pause() {
    if (this.paused || this.ended) return;
    this.carvedMs_ += this.now_() - this.since_;
    this.pause_ = makePause();
    this.onChange_();
  }

  resume() {
    const { pause_: pause } = this;
    if (!pause) return;
    this.pause_ = undefined;
    this.since_ = this.now_();
    pause.resolve();
    this.onChange_();
  }

  /** At once: rows that are being carved are as if they had not been begun. */
  end() {
    if (this.ended) return;
    this.ended = true;
    this.pause_?.resolve();
    this.pause_ = undefined;
    this.working_.forEach((engine) => engine.end());
    this.working_.clear();
    this.onChange_();
  }

  async work_() {
    /** @type {Engine | undefined} */ let engine;
    for (;;) {
      await this.pause_?.promise;
      if (this.ended || this.states_.next('waiting') < 0) break;
      try {
        engine ??= await this.startEngine_();
      } catch (thrown) {
        if (this.working_.size > 0) return;  // they go on without it
        this.losses_ += 1;
        if (!isLost(thrown) || this.losses_ >= kMostLosses) this.fail_(thrown);
        continue;
      }
      const index = this.ended || this.paused ? -1 : this.states_.next('waiting');  // others may have taken the last
      if (index >= 0 && !(await this.carve_(engine, this.unitOf_(index)))) {
        this.drop_(engine);
        engine = undefined;
      }
    }
    if (engine) this.drop_(engine);
  }

  /** The row, and those on the same plate: what is new on a plate makes all of it new. @param {number} index */
  unitOf_(index) {
    if (this.perPlate_ === 0) return [index];
    const first = index - (index % this.perPlate_);
    return Array.from({ length: Math.min(this.perPlate_, this.states_.size - first) }, (_, place) => first + place);
  }

  /** @param {Engine} engine @param {number[]} unit  rows @returns {Promise<boolean>}  whether the engine can go on */
  async carve_(engine, unit) {
    unit.forEach((index) => this.states_.set(index, 'running'));
    this.onChange_();
    try {
      const carved = await engine.carve(unit, (index) => index % this.printEvery_ === 0);
      const reasons = await this.save_(carved);
      this.settle_(unit, carved.rows.map(({ entry }, i) => ({ state: entry.status, reason: reasons[i] })));
      return true;
    } catch (thrown) {
      unit.forEach((index) => this.states_.set(index, 'waiting'));
      if (!this.ended) await this.lose_(unit, thrown);
      return false;
    } finally {
      this.onChange_();
    }
  }

  async startEngine_() {
    const engine = this.makeEngine_();
    this.working_.add(engine);
    try {
      await engine.start();
      return engine;
    } catch (thrown) {
      this.drop_(engine);
      throw thrown;
    }
  }

  /** @param {Engine} engine */
  drop_(engine) {
    engine.end();
    this.working_.delete(engine);
  }

  /** @param {number[]} unit @param {{ state: 'done' | 'failed', reason: string }[]} came  of each row */
  settle_(unit, came) {
    this.carved_ += unit.length;
    this.losses_ = 0;
    unit.forEach((index, i) => this.states_.set(index, came[i].state, came[i].reason));
  }

  /**
   * The engine was lost, or what was carved could not be kept. Rows are carved once more by a new engine; what was lost with
   * it again fails. What befalls every row ends the batch.
   * @param {number[]} unit @param {unknown} thrown
   */
  async lose_(unit, thrown) {
    const [index] = unit;
    const isAgain = this.lost_.has(index);
    this.lost_.add(index);
    this.losses_ += 1;
    if (!isLost(thrown) || this.losses_ > kMostLosses) {
      this.fail_(thrown);
    } else if (isAgain) {
      try {
        const reasons = await this.saveLost_(unit, describeThrown(thrown));
        this.settle_(unit, reasons.map((reason) => ({ state: 'failed', reason })));
      } catch (unsaved) {
        this.fail_(unsaved);
      }
    }
  }

  /** @param {unknown} thrown */
  fail_(thrown) {
    if (this.ended) return;
    this.problem = describeThrown(thrown);
    this.end();
  }
}

/** @returns {Pause} */
function makePause() {
  /** @type {() => void} */ let resolve = () => {};
  /** @type {Promise<void>} */ const promise = new Promise((settle) => { resolve = settle; });
  return { promise, resolve };
}
