// SPDX-License-Identifier: GPL-3.0-or-later
// Carves all parts of a batch after the first part was carved and checked, stores them, and continues after a reload.
import { saveArchive } from '../batch/archive.js';
import { BatchRun } from '../batch/batch_run.js';
import { readManifest } from '../batch/batch_store.js';
import { sha256 } from '../batch/hashes.js';
import { RowEngine } from '../batch/row_engine.js';
import { loadTracker } from '../batch/tracker.js';
import { EngineFailure, describeThrown, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { fileNameOf } from '../export/file_names.js';
import { text } from '../i18n/catalogue.js';
import { asSentence } from '../i18n/sentences.js';
import { modelName } from '../i18n/model_name.js';
import { overWords } from '../ui/parts_panel.js';
import { storedWork } from './work.js';

/** @typedef {import('../batch/batch_store.js').BatchRecord} BatchRecord */
/** @typedef {import('../batch/row_engine.js').BatchJob} BatchJob */
/** @typedef {import('../batch/tracker.js').Tracker} Tracker */
/** @typedef {import('../ui/parts_panel.js').Phase} Phase */

const kLock = 'qrelief-batch';
const kNotice = 'batch';
const kOfferNotice = 'batch-offer';
const kMostEngines = 2; // each holds its own module and model
const kLeastMemoryGb = 4; // device memory required for more than one engine
const kRoomLeft = 0.95; // usable share of the browser's free storage

/**
 * The open batch: stored, and being carved.
 * @typedef {{ record: BatchRecord, job: BatchJob, tracker: Tracker, release: () => void }} Open
 *   `release`: releases the lock of the batch's folder
 */

/**
 * @typedef {object} BatchCarvingOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('../batch/batch_store.js').BatchStore} storage
 * @property {import('./batching.js').Batching} batching
 * @property {import('./carving.js').Carving} carving
 * @property {import('./placing.js').Placing} placing
 * @property {import('./work_store.js').WorkStore} store
 * @property {import('../ui/parts_panel.js').PartsPanel} panel
 * @property {import('../ui/notices.js').Notices} notices
 * @property {import('../ui/messages.js').Messages} messages
 * @property {Pick<import('./work_editor.js').WorkEditor, 'continueWith'>} editor
 * @property {(action: () => Promise<unknown>) => Promise<void>} guard
 * @property {(job: BatchJob) => RowEngine} [makeEngine]
 */

export class BatchCarving {
  /** @param {BatchCarvingOptions} options */
  constructor(options) {
    this.options_ = options;
    /** @type {Open | undefined} */ this.open_ = undefined;
    /** @type {BatchRun | undefined} */ this.run_ = undefined;
    this.isStarting_ = false;
    const { panel, batching, carving, store, guard } = options;
    panel.listen({
      onBegin: (printEvery, atMost) => guard(() => this.begin(printEvery, atMost)),
      onPause: () => this.pause(),
      onResume: () => this.resume(),
      onStop: () => this.stop(),
      onRetry: () => this.retry(),
      onDownload: () => guard(() => this.download()),
      onDiscard: () => this.discard(),
      nameOf: (index) => this.nameOf(index),
    });
    batching.changed.on(() => this.show());
    carving.changed.on(() => this.show());
    store.applied.on(() => this.show());
  }

  /** True while a batch is open or starting. */
  get isOpen() {
    return this.open_ !== undefined || this.isStarting_;
  }

  /** Updates the panel: the first part or its settings changed. */
  show() {
    if (this.open_ || !this.options_.batching.input) return;
    const { carving, batching, panel } = this.options_;
    const { carved } = carving;
    const isOf = carved !== undefined && carving.isCurrent;
    const first = !isOf ? 'none' : carved.report.verification.verdict.passed ? 'good' : 'bad';
    panel.showBegin({ count: batching.planned?.plan?.rows ?? 0, first });
  }

  /**
   * Carves all parts like the first.
   * @param {number} printEvery  simulate the print of every n-th part
   * @param {number} atMost      parts to make, from the first one on; those on the last one's plate are made, too
   */
  async begin(printEvery, atMost) {
    const { batching, placing, store, client, storage } = this.options_;
    const { planned } = batching;
    const { source, centreMm } = store.work;
    const work = storedWork(store.work);
    if (this.isOpen || !planned?.plan || !planned.first || !source || !work || !centreMm) return;
    this.isStarting_ = true;
    /** @type {(() => void) | undefined} */ let release;
    try {
      release = await holdLock();
      const perFile = planned.request.perPlate || 1;
      const count = Math.min(planned.plan.rows, Math.ceil(atMost / perFile) * perFile);
      await this.checkRoom_(count, planned.first);
      const settings = {
        ...planned.request.settings,
        ...(placing.placement?.direction && { direction: placing.placement.direction }),
      };
      /** @type {BatchJob} */
      const job = {
        model: source,
        input: await sha256(/** @type {Uint8Array<ArrayBuffer>} */ (source.bytes)),
        centreMm,
        list: planned.input.list,
        request: { ...planned.request, settings: /** @type {any} */ (settings) },
      };
      const { bytes: _, batch, ...rest } = work;
      /** @type {BatchRecord} */
      const record = {
        work: { ...rest, ...(batch && { batch: { ...batch, list: new Uint8Array() } }) },
        rows: count,
        printEvery,
        centreMm: job.centreMm,
        request: job.request,
        input: job.input,
        settingsOfFirst: await settingsOfFirst(job, client),
      };
      const tracker = await trackerOf(record);
      await storage.begin(record, { model: source.bytes, list: job.list });
      void navigator.storage.persist?.();
      this.open_ = { record, job, tracker, release };
    } catch (thrown) {
      release?.();
      throw thrown;
    } finally {
      this.isStarting_ = false;
    }
    batching.lock(true);
    this.carve_();
    this.options_.panel.reveal();
  }

  /**
   * Throws if the storage has no room for all files.
   * @param {number} count
   * @param {import('../engine/types.js').BatchRow} first
   */
  async checkRoom_(count, { file }) {
    const { quota = Infinity, usage = 0 } = (await navigator.storage?.estimate?.()) ?? {};
    const files = await this.options_.client.exportFiles(file);
    const ofRow = files.reduce((sum, { bytes }) => sum + bytes.length, 0);
    const [needed, room] = [count * ofRow, kRoomLeft * (quota - usage)].map((size) => Math.round(size / 1e6));
    if (needed <= room) return;
    throw new EngineFailure(
      internal(message('storage-too-small', { count: { count }, needed: { count: needed }, room: { count: room } })),
    );
  }

  /** Carves the remaining rows. @param {boolean} [retriesFailed] */
  carve_(retriesFailed = false) {
    const { open_: open } = this;
    if (!open || this.run_) return;
    const { job, tracker } = open;
    const {
      client,
      storage,
      messages,
      panel,
      makeEngine = (/** @type {BatchJob} */ given) => new RowEngine(given),
    } = this.options_;
    tracker.run(retriesFailed ? 'retry' : 'start');
    const run = new BatchRun({
      tracker,
      engines: engineCount(),
      makeEngine: () => makeEngine(job),
      save: (carved) => storage.save(carved, tracker.manifestLine),
      saveLost: async ([{ index }], why) => {
        const entries = await client.unitEntries(index, { input: job.input, settings: [] });
        const rows = entries.map((entry) => ({ entry, why }));
        return storage.save({ rows, files: [] }, tracker.manifestLine);
      },
      onChange: () => this.showProgress_(),
      onProgress: () => panel.showCarved(this.carved_),
    });
    this.run_ = run;
    messages.say(() => text('batch.getReady'));
    void run.run().then(() => {
      if (this.run_ !== run) return;
      this.run_ = undefined;
      if (this.open_ === open) this.showEnd_(run);
    });
    this.showProgress_();
  }

  /** Reports the end of the run. @param {BatchRun} run */
  showEnd_({ problem }) {
    const { messages } = this.options_;
    this.showProgress_();
    if (problem) messages.showError(problem);
    const { state_: state } = this;
    const { rows: count } = /** @type {Open} */ (this.open_).record;
    const { finished } = state;
    const isOver = this.phase_ === 'over';
    messages.say(() => asSentence(isOver ? overWords(state) : text('batch.stopped', { finished, count })));
  }

  /** @returns {Phase} */
  get phase_() {
    const { running, finished } = this.state_;
    const isFinished = finished === /** @type {Open} */ (this.open_).record.rows;
    if (!this.run_ || this.run_.ended) return isFinished ? 'over' : 'stopped';
    if (this.run_.paused) return running > 0 ? 'pausing' : 'paused';
    return running === 0 && !isFinished ? 'starting' : 'carving';
  }

  /** Counts of the open batch's rows. */
  get state_() {
    return /** @type {Open} */ (this.open_).tracker.state({ workedMs: this.run_?.workedMs });
  }

  /** Number of carved rows, with the carved part of those that are not finished. */
  get carved_() {
    return this.state_.finished + (this.run_?.partly ?? 0);
  }

  showProgress_() {
    if (!this.open_) return;
    const { tracker, record } = this.open_;
    const { panel } = this.options_;
    panel.showProgress({ tracker, rows: record.rows, state: this.state_, phase: this.phase_ });
    panel.showCarved(this.carved_);
  }

  pause() {
    this.run_?.pause();
  }

  resume() {
    if (this.run_) this.run_.resume();
    else this.carve_();
  }

  /** Stops at once; carved parts are kept. */
  stop() {
    this.run_?.end();
  }

  /** Carves the failed rows again. */
  retry() {
    this.carve_(true);
  }

  /** Downloads all parts carved so far. */
  async download() {
    const { storage, panel, messages } = this.options_;
    if (!this.open_) return;
    const { record, tracker } = this.open_;
    const { fileName } = record.work;
    panel.setSaving(true);
    try {
      const name = fileNameOf({ modelFile: fileName, text: '', addition: 'parts', extension: 'zip' });
      messages.say(() => text('batch.downloading'));
      const isSaved = await saveArchive(storage, tracker, name);
      messages.say(() => (isSaved ? text('batch.downloaded') : ''));
    } finally {
      panel.setSaving(false);
    }
  }

  /** Discards the batch after asking. */
  discard() {
    const {
      open_: open,
      options_: { notices },
    } = this;
    if (!open) return;
    notices.show(kNotice, text('batch.askDiscard', { count: this.state_.done }), [
      { label: text('batch.keepThem'), run: () => {} },
      { label: text('batch.discard'), run: () => void this.options_.guard(() => this.discardNow_()), primary: true },
    ]);
  }

  async discardNow_() {
    const { storage, batching } = this.options_;
    const { open_: open, run_: run } = this;
    this.open_ = undefined;
    this.run_ = undefined;
    run?.end();
    await storage.discard();
    open?.release();
    batching.lock(false);
    this.show();
  }

  /**
   * Offers the batch of the last visit.
   * @returns {Promise<boolean>}  false: there is none, or another tab has it open
   */
  async offer() {
    const { storage, notices, guard } = this.options_;
    const record = await storage.recall();
    if (!record) return false;
    /** @type {() => void} */ let release;
    try {
      release = await holdLock();
    } catch {
      return false; // another tab has it open
    }
    const tracker = await trackerOf(record);
    await readManifest(await storage.manifest(), tracker, { restores: true });
    const { done, finished } = tracker.state({});
    const isOver = finished === record.rows;
    const values = { done, count: record.rows, name: modelName(record.work) };
    notices.show(kOfferNotice, text(isOver ? 'batch.offerOver' : 'batch.offer', values), [
      { label: text('autosave.discard'), run: () => void guard(() => storage.discard().finally(release)) },
      {
        label: text(isOver ? 'batch.showThem' : 'batch.goOn'),
        run: () => void guard(() => this.goOn_(record, tracker, release)),
        primary: true,
      },
    ]);
    return true;
  }

  /** @param {BatchRecord} record @param {Tracker} tracker @param {() => void} release */
  async goOn_(record, tracker, release) {
    const { storage, client, editor, batching, panel } = this.options_;
    const { model: bytes, list } = await storage.files();
    const { work } = record;
    await editor.continueWith({
      ...work,
      ...(work.sampleId === undefined && { bytes }),
      ...(work.batch && { batch: { ...work.batch, list } }),
    });
    await batching.ready();
    const { centreMm, request, input } = record;
    const job = {
      model: { bytes, fileName: work.fileName, scaleToMm: work.scaleToMm, upAxis: work.upAxis },
      input,
      centreMm,
      list,
      request,
    };
    const now = { ...record, settingsOfFirst: await settingsOfFirst(job, client) };
    if (now.settingsOfFirst !== record.settingsOfFirst) {
      // The program has changed: carve all rows again.
      await storage.begin(now, { model: bytes, list });
      tracker.begin(layoutOf(now));
    }
    this.open_ = { record: now, job, tracker, release };
    batching.lock(true);
    this.showProgress_();
    panel.reveal();
    if (this.phase_ !== 'over') this.carve_();
  }

  /**
   * Returns a row's number, id, text and file name.
   * @param {number} index
   * @returns {Promise<import('../engine/types.js').BatchRowName | undefined>}  undefined while the module is replaced
   */
  async nameOf(index) {
    // A new module gets the list again.
    return this.options_.client.batchRow(index).catch(() => undefined);
  }
}

/** @param {BatchRecord} record */
const layoutOf = ({ rows, request: { perPlate }, printEvery }) => ({ rows, perPlate, printEvery });

/** Returns a tracker of a batch whose rows all wait. @param {BatchRecord} record */
async function trackerOf(record) {
  const tracker = await loadTracker();
  tracker.begin(layoutOf(record));
  return tracker;
}

/**
 * Returns the hash of the first row's settings. It differs if the program has changed.
 * @param {BatchJob} job @param {import('../engine/client.js').EngineClient} client
 */
async function settingsOfFirst(job, client) {
  const [{ sha256: hashes }] = await new RowEngine(job, { client }).pending(0);
  return hashes.settings;
}

/** Returns the number of parallel engines: one without OffscreenCanvas, as the engine then blocks the page. */
function engineCount() {
  if (typeof OffscreenCanvas !== 'function') return 1;
  const memory = /** @type {{ deviceMemory?: number }} */ (navigator).deviceMemory ?? kLeastMemoryGb;
  return memory < kLeastMemoryGb ? 1 : Math.max(1, Math.min(kMostEngines, navigator.hardwareConcurrency || 1));
}

/**
 * Locks the batch's folder against other tabs.
 * @returns {Promise<() => void>}  releases the lock
 * @throws {EngineFailure} if another tab holds the lock
 */
async function holdLock() {
  if (!navigator.locks) return () => {};
  return new Promise((resolve, reject) => {
    navigator.locks
      .request(kLock, { ifAvailable: true }, (lock) => {
        if (!lock) {
          reject(new EngineFailure({ kind: 'BadUsage', ...message('batch-elsewhere') }));
          return undefined;
        }
        return new Promise((release) => resolve(() => release(undefined)));
      })
      .catch((thrown) => reject(new EngineFailure(describeThrown(thrown))));
  });
}
