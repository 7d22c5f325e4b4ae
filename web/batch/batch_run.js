// SPDX-License-Identifier: GPL-3.0-or-later
// Carves the remaining rows of a batch with several parallel engines. Each free engine takes the next row.
import { describeThrown } from '../engine/engine_error.js';
import { isLost } from './carver.js';

/** @typedef {import('./row_engine.js').CarvedUnit} CarvedUnit */
/** @typedef {import('../engine/message.js').Message} Message */
/** @typedef {{ promise: Promise<void>, resolve: () => void }} Pause */
/** @typedef {Pick<import('./row_engine.js').RowEngine, 'start' | 'end' | 'carve'>} Engine */

const kMostLosses = 3; // consecutive engine losses without a finished row

/**
 * @typedef {object} BatchRunOptions
 * @property {import('./row_states.js').RowStates} states  row states, updated here
 * @property {() => Engine} makeEngine
 * @property {number} engines                 number of engines
 * @property {number} printEvery              simulate the print of every n-th row, starting with the first
 * @property {number} perPlate                rows per file; 0: one file per row
 * @property {(carved: CarvedUnit) => Promise<string[]>} save
 *   stores the result; returns each row's failure reason, '' if none
 * @property {(indices: number[], why: Message) => Promise<string[]>} saveLost
 *   the same for rows that keep crashing engines
 * @property {() => void} onChange
 * @property {() => number} [now]  ms
 */

export class BatchRun {
  /** @param {BatchRunOptions} options */
  constructor({
    states,
    makeEngine,
    engines,
    printEvery,
    perPlate,
    save,
    saveLost,
    onChange,
    now = () => performance.now(),
  }) {
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
    /** @type {Set<number>} */ this.lost_ = new Set(); // first row of each unit that crashed an engine
    this.losses_ = 0;
    this.ended = false;
    /** @type {Pause | undefined} */ this.pause_ = undefined;
    /** Error that ended the run early. @type {Message | undefined} */ this.problem = undefined;
    this.carved_ = 0;
    this.carvedMs_ = 0;
    this.since_ = now();
  }

  get paused() {
    return this.pause_ !== undefined;
  }

  /**
   * Estimated time to the end at the current pace, ms; undefined before the first row.
   * @returns {number | undefined}
   */
  get remainingMs() {
    const { waiting, running } = this.states_.counts;
    if (this.carved_ === 0) return undefined;
    const workedMs = this.carvedMs_ + (this.paused ? 0 : this.now_() - this.since_);
    return (workedMs / this.carved_) * (waiting + running);
  }

  /** Runs until all rows are carved or end() is called. */
  async run() {
    const engines = Math.max(1, Math.min(this.engines_, this.states_.counts.waiting));
    await Promise.all(Array.from({ length: engines }, () => this.work_()));
    this.end();
  }

  /** Pauses after the current rows. */
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

  /** Ends at once. Unfinished rows wait again. */
  end() {
    if (this.ended) return;
    this.ended = true;
    this.pause_?.resolve();
    this.pause_ = undefined;
    this.working_.forEach((engine) => engine.end());
    this.working_.clear();
    this.onChange_();
  }

  /** Carves rows with one engine until none is waiting. */
  async work_() {
    /** @type {Engine | undefined} */ let engine;
    for (;;) {
      await this.pause_?.promise;
      if (this.ended || this.states_.next('waiting') < 0) break;
      try {
        engine ??= await this.startEngine_();
      } catch (thrown) {
        if (this.working_.size > 0) return; // the others go on without it
        this.losses_ += 1;
        if (!isLost(thrown) || this.losses_ >= kMostLosses) this.fail_(thrown);
        continue;
      }
      const index = this.ended || this.paused ? -1 : this.states_.next('waiting'); // the last one may be taken
      if (index >= 0 && !(await this.carve_(engine, this.unitOf_(index)))) {
        this.drop_(engine);
        engine = undefined;
      }
    }
    if (engine) this.drop_(engine);
  }

  /** Returns the row and all others on its plate: a plate is carved as a whole. @param {number} index */
  unitOf_(index) {
    if (this.perPlate_ === 0) return [index];
    const first = index - (index % this.perPlate_);
    return Array.from({ length: Math.min(this.perPlate_, this.states_.size - first) }, (_, place) => first + place);
  }

  /**
   * Carves and saves a unit.
   * @param {Engine} engine
   * @param {number[]} unit  rows
   * @returns {Promise<boolean>}  false: drop the engine
   */
  async carve_(engine, unit) {
    unit.forEach((index) => this.states_.set(index, 'running'));
    this.onChange_();
    try {
      const carved = await engine.carve(unit, (index) => index % this.printEvery_ === 0);
      const reasons = await this.save_(carved);
      this.settle_(
        unit,
        carved.rows.map(({ entry }, i) => ({ state: entry.status, reason: reasons[i] })),
      );
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

  /**
   * Records results.
   * @param {number[]} unit
   * @param {{ state: 'done' | 'failed', reason: string }[]} came  result per row
   */
  settle_(unit, came) {
    this.carved_ += unit.length;
    this.losses_ = 0;
    unit.forEach((index, i) => this.states_.set(index, came[i].state, came[i].reason));
  }

  /**
   * Handles a lost engine or a failure to save. A new engine carves the rows once more; if it is lost too, the rows
   * fail. Errors that would affect every row end the run.
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
        this.settle_(
          unit,
          reasons.map((reason) => ({ state: 'failed', reason })),
        );
      } catch (unsaved) {
        this.fail_(unsaved);
      }
    }
  }

  /** Ends the run with an error. @param {unknown} thrown */
  fail_(thrown) {
    if (this.ended) return;
    this.problem = describeThrown(thrown);
    this.end();
  }
}

/** @returns {Pause} */
function makePause() {
  /** @type {() => void} */ let resolve = () => {};
  /** @type {Promise<void>} */ const promise = new Promise((settle) => {
    resolve = settle;
  });
  return { promise, resolve };
}
