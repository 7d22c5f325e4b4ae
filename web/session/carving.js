// SPDX-License-Identifier: GPL-3.0-or-later
// Carves the code, decodes the result, and offers it for download.
import { isReplaced } from '../engine/client.js';
import { isFatal } from '../engine/engine_error.js';
import { kReaderName, prepareReader, readEach } from '../decoder/reader.js';
import { text } from '../i18n/catalogue.js';
import { attemptWords, engravedWords } from './attempt_words.js';
import { carvedSource, saveMaps, saveModel, saveReport } from './save_carving.js';
import { Signal } from './signal.js';
import { tryViews } from './view_trials.js';
import { sameWork, withChanges } from './work.js';

/** @typedef {import('./work.js').Work} Work */
/** @typedef {import('../ui/result_panel.js').Result & { number: number, life: number, work: Work }} Carved
 *   `number`: of the carving in its module; `life`: number of that module; `work`: the work it was carved from */
/** @typedef {import('../i18n/live.js').Words} Words */

/**
 * @typedef {object} CarvingOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('./jobs.js').Jobs} jobs
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./placing.js').Placing} placing
 * @property {import('../ui/messages.js').Messages} messages
 * @property {import('../ui/result_panel.js').ResultPanel} panel
 * @property {import('./printing.js').Printing} printing
 * @property {import('./work_store.js').WorkStore} store
 * @property {Pick<import('./batching.js').Batching, 'settings' | 'decided' | 'explainMissingCode'>} batching
 * @property {(remedy: import('../engine/types.js').Remedy, label: string) => Promise<unknown>} onRemedy
 * @property {(source: import('./model_session.js').Source) => Promise<unknown>} onAnother  the carved model, for another code
 * @property {(action: () => Promise<unknown>) => Promise<unknown>} guard  runs an action that nobody awaits
 */

/** @type {import('../engine/types.js').ModelInfo['only3mf']} */ const kNothing = [];

export class Carving {
  /** @param {CarvingOptions} options */
  constructor(options) {
    const { client, jobs, model, placing, messages, panel, printing, store, batching, guard } = options;
    this.client_ = client;
    this.jobs_ = jobs;
    this.model_ = model;
    this.placing_ = placing;
    this.messages_ = messages;
    this.panel_ = panel;
    this.printing_ = printing;
    this.store_ = store;
    this.batching_ = batching;
    this.guard_ = guard;
    /** Announces the start of a carving. @type {Signal<[]>} */ this.started = new Signal();
    /** Announces a new result. @type {Signal<[]>} */ this.finished = new Signal();
    /** Announces whether a carved model exists and whether it is shown. @type {Signal<[boolean, boolean]>} */
    this.changed = new Signal();
    /** Announces the simulated print of the carved model. @type {Signal<[]>} */ this.printed = new Signal();
    /** @type {Carved | undefined} */ this.carved = undefined;
    /** The carving that the one under way is to replace. @type {Carved | undefined} */ this.before_ = undefined;
    this.shown = false;
    this.life_ = 0;
    this.clickedMs_ = 0; // when the user pressed Engrave
    this.reached_ = 0; // progress since then
    /** The work that the engraving was asked for. */ this.asked_ = store.work;
    /** Says what the attempt under way changes. @type {Words | undefined} */ this.attempt_ = undefined;
    /** The work of each attempt, by its carving. @type {Map<number, Work>} */ this.works_ = new Map();
    /** True from a click on Engrave until the module begins to engrave. */ this.isOwed_ = false;
    /** @type {Promise<void> | undefined} */ this.running_ = undefined;
    /** @type {Promise<unknown>} */ this.restoring_ = Promise.resolve();
    panel.listen({
      onDownload: (file) => guard(async () => this.carved && saveModel(client, this.carved, file)),
      onSaveReport: () => guard(async () => this.carved && saveReport(this.carved)),
      onSaveMaps: () => guard(async () => this.carved && saveMaps(client, this.carved)),
      onAnother: () => guard(async () => this.carved && options.onAnother(await carvedSource(client, this.carved))),
      onPrint: (isOn) => this.print(isOn),
      onTryPrints: () => guard(() => this.tryPrints()),
      onTryViews: (...options) => this.tryViewsGuarded_(...options),
      onRemedy: (remedy, label) => guard(() => options.onRemedy(remedy, label)),
    });
    store.changed.on(() => this.compare());
    placing.moved.on(() => void guard(() => this.show(false))); // the carving is at another place now
  }

  /**
   * Carves the code.
   * @param {string} [overrides]  the inspector's settings in words, to use them; else the page's are used
   */
  async engrave(overrides) {
    if (this.running_ || this.jobs_.busy || !this.model_.engravable) return;
    this.messages_.clearError();
    this.placing_.confirmCentre();
    this.clickedMs_ = performance.now();
    this.reached_ = 0;
    this.isOwed_ = overrides === undefined; // a lost module's inspector is closed
    try {
      await this.run_(
        () => text('page.preparing'),
        async (signal) => {
          if (await this.place_(signal)) await this.carve_(signal, overrides);
          this.isOwed_ = false;
        },
      );
    } catch (thrown) {
      this.isOwed_ &&= isReplaced(thrown) || isFatal(thrown);
      throw thrown;
    }
  }

  /** Engraves with a new module if the last one was lost before it began to. */
  async resume() {
    if (this.isOwed_) await this.engrave();
  }

  /**
   * Runs a job.
   * @param {import('../i18n/live.js').Words} stage  first stage
   * @param {(signal: AbortSignal) => Promise<void>} carve
   * @param {number} [reached]  see Jobs.run
   */
  run_(stage, carve, reached) {
    this.running_ = this.jobs_.run(stage, carve, reached).finally(() => {
      this.running_ = this.before_ = undefined;
    });
    return this.running_;
  }

  /**
   * Finds the placement with the newest settings. Does not wait for it if cancelled.
   * @param {AbortSignal} signal
   * @returns {Promise<boolean>}  false: no placement, or cancelled; the page shows why
   */
  async place_(signal) {
    /** @type {Promise<void>} */ const aborted = new Promise((resolve) =>
      signal.addEventListener('abort', () => resolve(), { once: true }),
    );
    await Promise.race([this.placing_.place(), aborted]);
    const isPlaced = this.placing_.placement !== undefined;
    if (signal.aborted) this.messages_.say(() => text('page.cancelled'));
    else if (!isPlaced) await this.batching_.explainMissingCode();
    return !signal.aborted && isPlaced;
  }

  /** Aborts a running carving. */
  abort() {
    if (this.running_) this.jobs_.abort();
  }

  /** Drops the carving. */
  async drop() {
    this.carved = undefined;
    this.printing_.stop();
    this.panel_.hide();
    await this.show(false);
  }

  /** Drops the carving and all earlier ones: their module was replaced. */
  async dropForGood() {
    this.life_ += 1;
    await this.drop();
  }

  /**
   * Restores an earlier carving.
   * @param {Carved | undefined} carved
   * @returns {Promise<boolean>}  false: it is gone
   */
  async restore(carved) {
    if (!carved || carved.life !== this.life_ || !(await this.client_.useCarving(carved.number))) {
      await this.drop();
      return false;
    }
    this.printing_.stop();
    carved.report = await this.client_.report(); // attempts since then have left other remedies
    this.carved = carved;
    this.panel_.show(carved);
    this.compare();
    await this.show(sameWork(carved.work, this.store_.work));
    if (carved.printed?.state !== 'made') this.print(true);
    return true;
  }

  /** What all carvings of the loaded model have in common. */
  get ground_() {
    return { life: this.life_, only3mf: this.model_.info?.only3mf ?? kNothing };
  }

  /** Time since the user pressed Engrave. */
  get elapsedMs() {
    return performance.now() - this.clickedMs_;
  }

  /** The carving; while another is being made, the one before it. */
  get latest() {
    return this.carved ?? this.before_;
  }

  get isPrinting() {
    return this.carved?.printed?.state === 'under-way';
  }

  /** True if model and settings have not changed since the carving. */
  get isCurrent() {
    return this.carved !== undefined && sameWork(this.carved.work, this.store_.work);
  }

  /** Marks the result as outdated if model or settings have changed since. */
  compare() {
    if (this.carved) this.panel_.setOutdated(!sameWork(this.carved.work, this.store_.work));
  }

  /** @param {boolean} isShown */
  async show(isShown) {
    const exists = this.carved !== undefined;
    this.shown = isShown && exists;
    this.changed.emit(exists, this.shown);
    await this.client_.show({ carved: this.shown });
  }

  /**
   * Engraves with the chosen settings, and with changed ones where the result does not decode. The controls show the
   * changes of the attempt that is kept.
   * @param {AbortSignal} signal
   * @param {string} [overrides]
   */
  async carve_(signal, overrides) {
    await this.restoring_;
    const { carved: before } = this;
    this.before_ = before;
    await this.drop();
    this.started.emit();
    const asked = this.store_.work;
    this.asked_ = asked;
    this.works_.clear();
    prepareReader();
    this.printing_.expect();
    const unsound = asked.settings.content === 'text' ? 'fine' : 'unread';
    const job = this.jobOf_(signal, asked, () => (this.works_.size > 0 ? unsound : 'failed'));
    const step = await this.untilRead_(
      this.client_.engrave({
        ...job,
        options: { fixed: this.batching_.decided, offers: true },
        withOverrides: overrides !== undefined,
      }),
      job,
    );
    if (step?.delivery) {
      const work = await this.keep_(step.delivery, sameWork(asked, this.store_.work));
      this.messages_.say(() => this.wordsFor_(work, asked, overrides));
      return;
    }
    if (signal.aborted) {
      this.messages_.say(() => text('page.cancelled'));
      this.restoring_ = this.endEarly_(before).catch(() => {}); // not awaited: the module's step must end first
      return;
    }
    await this.endEarly_(before);
    const { work } = this.carved ?? {};
    if (work) this.messages_.say(() => this.wordsFor_(work, asked, overrides));
  }

  /** Shows the best attempt of the engraving so far, else the carving before it. @param {Carved | undefined} before */
  async endEarly_(before) {
    this.printing_.stop();
    const best = await this.client_.endEngrave();
    if (best && this.works_.has(best.number)) await this.keep_(best);
    else await this.restore(before);
  }

  /**
   * Returns the options of an engraving's job. Its progress says what an attempt changes, and why it is made.
   * @param {AbortSignal} signal
   * @param {Work} from  the work that the attempts are compared with
   * @param {() => import('./attempt_words.js').Reason} reason
   * @returns {import('../engine/client.js').EngraveJobOptions}
   */
  jobOf_(signal, from, reason) {
    /** @type {string | undefined} */ let attempt;
    return {
      signal,
      onProgress: (progress) => {
        this.isOwed_ = false;
        const { changes = [] } = progress;
        if (JSON.stringify(changes) !== attempt) {
          attempt = JSON.stringify(changes);
          this.attempt_ = changes.length > 0 ? attemptWords(this.after_(changes), from, reason()) : undefined;
          if (this.carved) this.panel_.setAttempt(this.attempt_);
        }
        this.reached_ = Math.max(this.reached_, progress.fraction);
        this.jobs_.showProgress({ ...progress, fraction: this.reached_ }, this.attempt_);
      },
      onPrintable: (print) => this.printing_.beginEarly(print),
    };
  }

  /**
   * Decodes the attempts of an engraving until one is to be printed, or the engraving ends.
   * @param {ReturnType<import('../engine/client.js').EngineClient['engrave']>} begun
   * @param {import('../engine/client.js').EngraveJobOptions} job
   * @returns {ReturnType<import('../engine/client.js').EngineClient['engrave']>}
   *   undefined: cancelled, or the user changed something
   */
  async untilRead_(begun, job) {
    const { work } = this.store_;
    let last = 0;
    let step = await begun;
    while (step) {
      this.works_.set(step.carving, this.after_(step.changes));
      if (step.needs !== 'texts') {
        if (step.carving !== last) this.printing_.stop(); // it prints the last attempt
        return step;
      }
      last = step.carving;
      this.messages_.say(() => text('page.readingBack'));
      // Meanwhile the module prepares the carved model for display.
      const [texts] = await Promise.all([readEach(step.pictures), this.client_.show({ carved: true })]);
      if (!sameWork(work, this.store_.work)) {
        await this.client_.setReadings(texts, kReaderName);
        return undefined;
      }
      step = await this.client_.continueEngrave({ ...job, read: { texts, reader: kReaderName } });
    }
    return step;
  }

  /**
   * Returns the asked work with the changes of an attempt.
   * @param {import('../engine/types.js').SettingChange[]} changes
   * @returns {Work}
   */
  after_(changes) {
    if (changes.length === 0) return this.asked_;
    return { ...this.asked_, ...withChanges(this.asked_, changes) };
  }

  /** @param {Work} work @param {Work} asked @param {string} [overrides] */
  wordsFor_(work, asked, overrides) {
    if (overrides) return text('inspector.engraved', { overrides });
    if (this.carved?.report.verification.verdict.reads.level === 'bad') return text('page.engravedUnread');
    return work === asked ? text('page.engraved') : engravedWords(work, asked);
  }

  /**
   * Makes an attempt the result, and starts its print.
   * @param {import('../engine/types.js').Delivery} delivery
   * @param {boolean} [goesOn]  the engraving goes on after its print
   * @returns {Promise<Work>}  the attempt's
   */
  async keep_({ number, report, seen }, goesOn = false) {
    const work = this.works_.get(number) ?? this.asked_;
    await this.adopt_(work, this.asked_);
    this.carved = { report, elapsedMs: this.elapsedMs, number, work, seen, ...this.ground_ };
    await this.present_();
    this.print(true, goesOn);
    return work;
  }

  /**
   * Takes the settings of the attempt that is kept, unless the user has changed something meanwhile.
   * @param {Work} work
   * @param {Work} before  the work whose settings the controls show
   */
  async adopt_(work, before) {
    if (work === before || !sameWork(before, this.store_.work)) return;
    this.store_.update({ text: work.text, settings: work.settings });
    await this.client_.configure(this.batching_.settings());
  }

  /** Shows a new carving. */
  async present_() {
    await this.show(true);
    if (this.carved) this.panel_.show(this.carved);
    this.compare();
    this.panel_.reveal();
    this.finished.emit();
  }

  /**
   * Starts or stops simulating the carving's print.
   * @param {boolean} isOn       false: stop
   * @param {boolean} [mayDeepen]  carve deeper if the print barely decodes
   */
  print(isOn, mayDeepen = false) {
    const { carved } = this;
    if (!isOn || !carved) {
      this.printing_.stop();
      return;
    }
    carved.printed = undefined;
    void this.printing_.begin(carved.number, (printed, result) => {
      carved.printed = printed;
      if (result) carved.report = result.report;
      if (result && mayDeepen) carved.elapsedMs = this.elapsedMs;
      if (this.carved !== carved) return;
      this.panel_.update();
      if (!result) return;
      this.printed.emit();
      if (mayDeepen && result.more) void this.guard_(() => this.deepen_(carved));
    });
  }

  /**
   * Goes on with the engraving after the print of `first`: carves deeper if the print barely decodes, for example.
   * @param {Carved} first
   */
  async deepen_(first) {
    await this.running_?.catch(() => {}); // the job that made it is about to end
    if (this.running_ || this.jobs_.busy || this.carved !== first || !this.isCurrent) return;
    await this.run_(
      () => text('page.preparing'),
      (signal) =>
        this.improve_(first, signal).finally(() => {
          this.attempt_ = undefined;
          this.panel_.setAttempt(undefined);
        }),
      this.reached_,
    );
  }

  /**
   * Makes further attempts until one is delivered, the user cancels or changes something. Until then the best result so
   * far stays available.
   * @param {Carved} first
   * @param {AbortSignal} signal
   */
  async improve_(first, signal) {
    const reason = first.report.verification.verdict.prints.level === 'bad' ? 'print-unread' : 'print-barely';
    const job = this.jobOf_(signal, first.work, () => reason);
    /** @type {Map<number, Carved>} */ const made = new Map(); // those with a print, by number
    this.changed.emit(false, false);
    await this.client_.show({ carved: false });
    this.printing_.expect();
    let step = await this.untilRead_(this.client_.continueEngrave(job), job);
    while (step?.needs === 'print' && this.isCurrent) {
      const { carving: number } = step;
      const print = await this.printNow_(number, signal);
      if (!print) break;
      const { report } = print.result;
      const work = this.works_.get(number) ?? first.work;
      made.set(number, { ...first, seen: undefined, number, work, report, printed: print.printed });
      if (print.result.more) this.printing_.expect();
      step = await this.untilRead_(this.client_.continueEngrave(job), job);
      await this.prefer_(step && made.get(step.best));
    }
    const isDelivered = step?.needs === null;
    const { carved } = this;
    if (carved && isDelivered) carved.elapsedMs = this.elapsedMs;
    if (carved && carved !== first && isDelivered) {
      await this.present_();
      this.printed.emit();
      this.messages_.say(() => engravedWords(carved.work, first.work, true));
      return;
    }
    this.printing_.stop();
    this.restoring_ = this.client_
      .endEngrave()
      .then(() => this.restore(carved))
      .catch(() => false); // not awaited: the module's step must end first
    const end = signal.aborted ? 'page.cancelledDeeper' : this.isCurrent ? 'page.engravedFirst' : 'page.outdated';
    this.messages_.say(() => text(end));
  }

  /** Makes a better attempt the result while others are made. @param {Carved | undefined} better */
  async prefer_(better) {
    const { carved } = this;
    if (!better || !carved || better === carved) return;
    await this.adopt_(better.work, carved.work);
    this.carved = better;
    this.panel_.show(better);
    this.compare();
  }

  /**
   * Simulates a print and waits for it.
   * @param {number} number  of the carving
   * @param {AbortSignal} signal
   * @returns {Promise<{ result: import('../engine/types.js').PrintedResult, printed: import('../engine/types.js').Printed } | undefined>}
   *   undefined: cancelled or failed
   */
  async printNow_(number, signal) {
    const stop = () => this.printing_.stop();
    signal.addEventListener('abort', stop, { once: true });
    const { attempt_: attempt } = this;
    this.messages_.say(() => [...(attempt ? [attempt()] : []), text('page.printing')].join('. '));
    /** @type {Awaited<ReturnType<Carving['printNow_']>>} */ let print;
    await this.printing_.begin(number, (printed, result) => void (result && (print = { result, printed })));
    signal.removeEventListener('abort', stop);
    return print;
  }

  /** Simulates other ways to print the carving until stopped. */
  async tryPrints() {
    const { carved } = this;
    if (carved?.printed?.state !== 'made') return;
    const { printed } = carved;
    await this.printing_.tryOthers(carved.number, (trials) => {
      printed.trials = trials;
      if (this.carved === carved) this.panel_.update();
    });
  }

  /** @type {import('../ui/grades_panel.js').ViewTrier} */
  async tryViewsGuarded_(...options) {
    /** @type {import('../engine/types.js').ViewTrials | undefined} */ let trials;
    await this.guard_(async () => {
      trials = await tryViews(this.client_, ...options);
    });
    return trials;
  }
}
