// SPDX-License-Identifier: GPL-3.0-or-later
// Carves the remaining rows of a batch with several parallel engines. Each free engine takes the next row. The tracker
// knows which, and how to go on after an engine is lost.
import { describeThrown } from '../engine/engine_error.js';
import { isLost } from './carver.js';

/** @typedef {import('./row_engine.js').CarvedUnit} CarvedUnit */
/** @typedef {import('../engine/message.js').Message} Message */
/** @typedef {import('../engine/types.js').RowToCarve} RowToCarve */
/** @typedef {{ promise: Promise<void>, resolve: () => void }} Pause */
/** @typedef {Pick<import('./row_engine.js').RowEngine, 'start' | 'end' | 'carve'>} Engine */

/**
 * @typedef {object} BatchRunOptions
 * @property {Pick<import('./tracker.js').Tracker, 'state' | 'take' | 'settle' | 'lose' | 'run'>} tracker
 *   with a run that has started
 * @property {() => Engine} makeEngine
 * @property {number} engines                 number of engines
 * @property {(carved: CarvedUnit) => Promise<string>} save   stores the result; returns its manifest lines
 * @property {(unit: RowToCarve[], why: Message) => Promise<string>} saveLost
 *   the same for rows that keep crashing engines
 * @property {() => void} onChange
 * @property {() => void} [onProgress]        `partly` has changed
 * @property {() => number} [now]  ms
 */

export class BatchRun {
  /** @param {BatchRunOptions} options */
  constructor({
    tracker,
    makeEngine,
    engines,
    save,
    saveLost,
    onChange,
    onProgress = () => {},
    now = () => performance.now(),
  }) {
    this.tracker_ = tracker;
    this.makeEngine_ = makeEngine;
    this.engines_ = engines;
    this.save_ = save;
    this.saveLost_ = saveLost;
    this.onChange_ = onChange;
    this.onProgress_ = onProgress;
    this.now_ = now;
    /** @type {Set<Engine>} */ this.working_ = new Set();
    /** How many rows of its unit each engine has carved. @type {Map<Engine, number>} */ this.carved_ = new Map();
    this.ended = false;
    /** @type {Pause | undefined} */ this.pause_ = undefined;
    /** Error that ended the run early. @type {Message | undefined} */ this.problem = undefined;
    this.beforeMs_ = 0; // up to the last pause
    this.since_ = now();
  }

  get paused() {
    return this.pause_ !== undefined;
  }

  /** Time of the run without pauses, ms. */
  get workedMs() {
    return this.beforeMs_ + (this.paused ? 0 : this.now_() - this.since_);
  }

  /** How many rows are carved in units that are not finished; 0.5: half of one. */
  get partly() {
    return [...this.carved_.values()].reduce((sum, rows) => sum + rows, 0);
  }

  /** Runs until all rows are carved or end() is called. */
  async run() {
    const engines = Math.max(1, Math.min(this.engines_, this.tracker_.state({}).waiting));
    await Promise.all(Array.from({ length: engines }, () => this.work_()));
    this.end();
  }

  /** Pauses after the current rows. */
  pause() {
    if (this.paused || this.ended) return;
    this.beforeMs_ = this.workedMs;
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
    this.tracker_.run('end');
    this.pause_?.resolve();
    this.pause_ = undefined;
    this.working_.forEach((engine) => engine.end());
    this.working_.clear();
    this.carved_.clear();
    this.onChange_();
  }

  /** Carves rows with one engine until none is waiting. */
  async work_() {
    /** @type {Engine | undefined} */ let engine;
    for (;;) {
      await this.pause_?.promise;
      if (this.ended || this.tracker_.state({}).waiting === 0) break;
      try {
        engine ??= await this.startEngine_();
      } catch (thrown) {
        if (this.working_.size > 0) return; // the others go on without it
        if (!isLost(thrown) || this.tracker_.lose(-1) === 'stop') this.fail_(thrown);
        continue;
      }
      const unit = this.ended || this.paused ? [] : this.tracker_.take(); // the last one may be taken
      if (unit.length > 0 && !(await this.carve_(engine, unit))) {
        this.drop_(engine);
        engine = undefined;
      }
    }
    if (engine) this.drop_(engine);
  }

  /**
   * Carves and saves a unit.
   * @param {Engine} engine
   * @param {RowToCarve[]} unit
   * @returns {Promise<boolean>}  false: drop the engine
   */
  async carve_(engine, unit) {
    this.onChange_();
    try {
      const carved = await engine.carve(unit, (rows) => this.advance_(engine, rows));
      this.tracker_.settle(await this.save_(carved));
      return true;
    } catch (thrown) {
      if (!this.ended) await this.lose_(unit, thrown);
      return false;
    } finally {
      this.carved_.delete(engine);
      this.onChange_();
    }
  }

  /** @param {Engine} engine @param {number} rows */
  advance_(engine, rows) {
    if (this.ended) return;
    this.carved_.set(engine, rows);
    this.onProgress_();
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
   * Handles a lost engine or a failure to save. Errors that would affect every row end the run.
   * @param {RowToCarve[]} unit @param {unknown} thrown
   */
  async lose_(unit, thrown) {
    const then = isLost(thrown) ? this.tracker_.lose(unit[0].index) : 'stop';
    if (then === 'stop') this.fail_(thrown);
    if (then !== 'fail') return;
    try {
      this.tracker_.settle(await this.saveLost_(unit, describeThrown(thrown)));
    } catch (unsaved) {
      this.fail_(unsaved);
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
