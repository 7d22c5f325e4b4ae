// SPDX-License-Identifier: GPL-3.0-or-later
// Carves the code, reads it back, and hands out what came of it.
import { pixelsPerModule, tryViews } from '../check/view_trials.js';
import { kReaderName, prepareReader, readAll, reads } from '../reader/reader.js';
import { fileNameOf } from '../take/file_names.js';
import { text } from '../text/catalogue.js';
import { saveFile } from '../ui/save_file.js';

import { sameWork } from './work.js';

/** @typedef {import('./work.js').Work} Work */
/** @typedef {import('../ui/result_panel.js').Result & { number: number, life: number, made: Work }} Carved
 *   `number`: the module's; `life`: of which module; `made`: from what */

/**
 * @typedef {object} CarvingOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('./jobs.js').Jobs} jobs
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./placing.js').Placing} placing
 * @property {import('../ui/messages.js').Messages} messages
 * @property {import('../ui/result_panel.js').ResultPanel} panel
 * @property {() => Work} work
 * @property {() => void} onStart
 * @property {() => void} onDone
 * @property {(exists: boolean, shown: boolean) => void} onShown  whether there is a carved model, and whether it is seen
 */

export class Carving {
  /** @param {CarvingOptions} options */
  constructor({ client, jobs, model, placing, messages, panel, work, onStart, onDone, onShown }) {
    this.client_ = client;
    this.jobs_ = jobs;
    this.model_ = model;
    this.placing_ = placing;
    this.messages_ = messages;
    this.panel_ = panel;
    this.work_ = work;
    this.onStart_ = onStart;
    this.onDone_ = onDone;
    this.onShown_ = onShown;
    /** @type {Carved | undefined} */ this.carved = undefined;
    this.shown = false;
    this.life_ = 0;
    this.running_ = false;
    /** @type {Promise<unknown>} */ this.restoring_ = Promise.resolve();
  }

  /** @param {string} [overrides]  in words, of the inspector's settings, which count then; else the page's own do */
  async engrave(overrides) {
    if (this.running_ || this.jobs_.busy || !this.model_.engravable) return;
    this.running_ = true;
    try {
      this.messages_.clearError();
      this.placing_.centreIsGuess = false;  // from here on an error is worth saying
      await this.placing_.place();
      if (this.placing_.placement) await this.jobs_.run(() => text('page.preparing'), (signal) => this.carve_(signal, overrides));
    } finally {
      this.running_ = false;
    }
  }

  /** If it runs. */
  abort() {
    if (this.running_) this.jobs_.abort();
  }

  /** Nothing is carved any more. */
  async drop() {
    this.carved = undefined;
    this.panel_.hide();
    await this.show(false);
  }

  /** The module was replaced, and what it had carved went with it. */
  async dropForGood() {
    this.life_ += 1;
    await this.drop();
  }

  /**
   * Back to what was carved in an earlier state.
   * @param {Carved | undefined} carved
   * @returns {Promise<boolean>}  whether it is there again
   */
  async restore(carved) {
    if (!carved || carved.life !== this.life_ || !(await this.client_.useCarving(carved.number))) {
      await this.drop();
      return false;
    }
    this.carved = carved;
    this.panel_.show(carved);
    this.compare();
    await this.show(sameWork(carved.made, this.work_()));
    return true;
  }

  /** Whether the model or the settings have changed since. */
  compare() {
    if (this.carved) this.panel_.setOutdated(!sameWork(this.carved.made, this.work_()));
  }

  /** @param {boolean} shown */
  async show(shown) {
    const exists = this.carved !== undefined;
    this.shown = shown && exists;
    this.onShown_(exists, this.shown);
    await this.client_.showCarved(this.shown);
  }

  /** @param {AbortSignal} signal @param {string} [overrides] */
  async carve_(signal, overrides) {
    const started = performance.now();
    await this.restoring_;
    const { carved: before } = this;
    await this.drop();
    this.onStart_();
    const made = this.work_();
    prepareReader();
    const finished = await this.client_.engrave({
      signal, withOverrides: overrides !== undefined, onProgress: (progress) => this.jobs_.showProgress(progress),
    });
    if (finished) {
      await this.finish_(started, made, overrides);
    } else {
      this.messages_.say(() => text('page.cancelled'));
      this.restoring_ = this.restore(before).catch(() => false);  // once the module's step has ended: nobody waits for it
    }
  }

  /** @param {number} started @param {Work} made @param {string} [overrides] */
  async finish_(started, made, overrides) {
    this.messages_.say(() => text('page.readingBack'));
    const picture = await this.client_.readerImage();
    const { symbol } = await this.client_.report();
    const scanned = readAll(picture, pixelsPerModule(picture, symbol.modules));
    const [reading] = await Promise.all([scanned, this.client_.showCarved(true)]);  // which has to be made first
    await this.client_.setReadBack(reading.text, kReaderName);
    const [report, number] = await Promise.all([this.client_.report(), this.client_.carving()]);
    this.carved = { report, reading, elapsedMs: performance.now() - started, number, life: this.life_, made };
    await this.show(true);
    this.panel_.show(this.carved);
    this.panel_.reveal();
    this.onDone_();
    this.messages_.say(() => (overrides ? text('inspector.engraved', { overrides }) : text('page.engraved')));
  }

  /** @type {import('../ui/grades_panel.js').ViewTrier} */
  tryViews(report, onTrial, signal) {
    return tryViews({
      pictureFrom: (tiltDeg, azimuthDeg) => this.client_.readerImageFrom(tiltDeg, azimuthDeg),
      picture: () => this.client_.readerImage(),
      reads: (image) => reads(image, pixelsPerModule(image, report.symbol.modules), report.text),
      modules: report.symbol.modules,
      onTrial, signal,
    });
  }

  /** @param {string} format */
  async download(format) {
    const [extension, addition] = format.split('-');
    const bytes = await this.client_.exportModel(format);
    const name = this.nameOf_(await this.client_.report(), extension, addition);
    saveFile(new Blob([bytes], { type: `model/${extension}` }), name);
  }

  async saveReport() {
    const report = await this.client_.report();
    const json = JSON.stringify(report, null, 2);
    saveFile(new Blob([json], { type: 'application/json' }), this.nameOf_(report, 'json', 'report'));
  }

  /** @param {import('../engine/types.js').Report} report  of what is saved @param {string} extension @param {string} [addition] */
  nameOf_({ text: content, size }, extension, addition) {
    return fileNameOf({ modelFile: this.model_.source?.fileName ?? '', text: content, symbolMm: size.symbolMm, addition, extension });
  }
}
