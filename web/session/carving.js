// SPDX-License-Identifier: GPL-3.0-or-later
// Carves the code, reads it back, and hands out what came of it.
import { kReaderName, readCode } from '../reader/reader.js';
import { text } from '../text/catalogue.js';
import { saveFile } from '../ui/save_file.js';

/**
 * @typedef {object} CarvingOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('./jobs.js').Jobs} jobs
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./placing.js').Placing} placing
 * @property {import('../ui/messages.js').Messages} messages
 * @property {import('../ui/result_panel.js').ResultPanel} panel
 * @property {() => void} onStart
 * @property {(exists: boolean, shown: boolean) => void} onCarved  whether there is a carved model, and whether it is seen
 */

export class Carving {
  /** @param {CarvingOptions} options */
  constructor({ client, jobs, model, placing, messages, panel, onStart, onCarved }) {
    this.client_ = client;
    this.jobs_ = jobs;
    this.model_ = model;
    this.placing_ = placing;
    this.messages_ = messages;
    this.panel_ = panel;
    this.onStart_ = onStart;
    this.onCarved_ = onCarved;
    this.exists = false;
    this.running_ = false;
  }

  async engrave() {
    if (this.running_ || this.jobs_.busy || !this.model_.engravable) return;
    this.running_ = true;
    try {
      this.messages_.clearError();
      this.placing_.centreIsGuess = false;  // from here on an error is worth saying
      await this.placing_.place();
      if (this.placing_.placement) await this.jobs_.run(() => text('page.preparing'), (signal) => this.carve_(signal));
    } finally {
      this.running_ = false;
    }
  }

  /** If it runs. */
  abort() {
    if (this.running_) this.jobs_.abort();
  }

  /** What was carved is gone. */
  async drop() {
    this.panel_.hide();
    await this.setExists_(false);
  }

  markOutdated() {
    this.panel_.markOutdated();
  }

  /** @param {boolean} shown */
  async show(shown) {
    this.onCarved_(this.exists, shown && this.exists);
    if (this.exists) await this.client_.showCarved(shown);
  }

  /** @param {AbortSignal} signal */
  async carve_(signal) {
    const started = performance.now();
    await this.drop();
    this.onStart_();
    const finished = await this.client_.engrave({ signal, onProgress: (progress) => this.jobs_.showProgress(progress) });
    if (finished) await this.finish_(started);
    else this.messages_.say(() => text('page.cancelled'));
  }

  /** @param {number} started */
  async finish_(started) {
    await this.setExists_(true);
    this.messages_.say(() => text('page.readingBack'));
    const readBack = await readCode(await this.client_.readerImage());
    await this.client_.setReadBack(readBack, kReaderName);
    this.panel_.show({ report: await this.client_.report(), readBack, elapsedMs: performance.now() - started });
    this.panel_.scrollIntoView();
    this.messages_.say(() => text('page.engraved'));
  }

  /** @param {boolean} exists  and is shown */
  async setExists_(exists) {
    this.exists = exists;
    await this.show(exists);
  }

  /** @param {string} format */
  async download(format) {
    const bytes = await this.client_.exportModel(format);
    const [extension, addition] = format.split('-');
    saveFile(new Blob([bytes], { type: `model/${extension}` }),
      `${this.model_.baseName}-qr${addition ? `-${addition}` : ''}.${extension}`);
  }

  async saveReport() {
    const json = JSON.stringify(await this.client_.report(), null, 2);
    saveFile(new Blob([json], { type: 'application/json' }), `${this.model_.baseName}-qr.json`);
  }
}
