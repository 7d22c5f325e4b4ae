// SPDX-License-Identifier: GPL-3.0-or-later
// The model: where it came from, so that it can be opened again, and what the module says of it.
import { isReplaced } from '../engine/client.js';
import { text } from '../i18n/catalogue.js';
import { fetchBytes } from './fetch_file.js';

/** @typedef {import('../engine/types.js').ModelInfo} ModelInfo */
/** @typedef {import('../engine/types.js').UpAxis} UpAxis */
/** @typedef {import('../ui/model_panel.js').Sample} Sample */
/** @typedef {[number, number, number]} Point */
/** @typedef {{ bytes: Uint8Array, fileName: string, scaleToMm: number, upAxis: UpAxis, sampleId?: string, credit: string,
 *   unitStated?: boolean }} Source
 * `scaleToMm` of 0 leaves the unit to the file, and the true one is put in its place; `unitStated`: that was done */

const kMaxFileBytes = 512 * 1024 * 1024;  // beyond it a tab runs out of memory before it can say so

/**
 * @typedef {object} ModelOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('./jobs.js').Jobs} jobs
 * @property {import('../ui/messages.js').Messages} messages
 * @property {import('../ui/model_panel.js').ModelPanel} panel
 * @property {import('./centre.js').Centre} centre
 * @property {() => void} onReplacing          another model is about to be read
 * @property {() => Promise<void>} onLoaded    a model is there, with `source` and `info`
 * @property {() => void} onFailed             the model before it stays
 */

export class ModelSession {
  /** @param {ModelOptions} options */
  constructor({ client, jobs, messages, panel, centre, onReplacing, onLoaded, onFailed }) {
    this.client_ = client;
    this.jobs_ = jobs;
    this.messages_ = messages;
    this.panel_ = panel;
    this.centre_ = centre;
    this.onReplacing_ = onReplacing;
    this.onLoaded_ = onLoaded;
    this.onFailed_ = onFailed;
    /** @type {Sample[]} */ this.samples_ = [];
    /** @type {Source | undefined} */ this.source = undefined;
    /** @type {ModelInfo | undefined} */ this.info = undefined;
  }

  get engravable() {
    return this.info?.engravable ?? false;
  }

  /** @param {Sample[]} samples  at least one */
  setSamples(samples) {
    this.samples_ = samples;
    this.panel_.setSamples(samples);
  }

  /** @param {string} id */
  hasSample(id) {
    return this.samples_.some((known) => known.id === id);
  }

  /**
   * @param {string} [id]  none: the first
   * @param {Partial<Source> & { centreMm?: Point }} [place]  instead of the sample's own
   */
  async openSample(id = this.samples_[0].id, place = {}) {
    const sample = this.samples_.find((known) => known.id === id);
    if (!sample) {
      const names = this.samples_.map((known) => known.id).join(', ');
      this.messages_.showError({ found: () => text('page.noSample', { id }), help: () => text('page.samplesAre', { names }) });
      return;
    }
    const bytes = await fetchBytes(`samples/${sample.file}`);
    const { centreMm, ...instead } = { centreMm: sample.centreMm, ...place };
    await this.load({ bytes, fileName: sample.file, scaleToMm: 1, upAxis: 'z', sampleId: id, credit: sample.credit, ...instead }, centreMm);
  }

  /** @param {File} file */
  async openFile(file) {
    if (file.size > kMaxFileBytes) {
      const values = { file: file.name, size: Math.round(file.size / 2 ** 20), limit: kMaxFileBytes / 2 ** 20 };
      this.messages_.showError({ found: () => text('page.tooLarge', values), help: () => text('page.tooLargeHint') });
      return;
    }
    const bytes = new Uint8Array(await file.arrayBuffer());
    const { upAxis } = this.panel_;  // the last ones chosen: parts of one origin share them
    const scaleToMm = /\.3mf$/i.test(file.name) ? 0 : this.source?.unitStated ? 1 : this.panel_.scaleToMm;
    await this.load({ bytes, fileName: file.name, scaleToMm, upAxis, credit: '' });
  }

  /** @param {number} scaleToMm */
  async rescale(scaleToMm) {
    if (!this.source) return;
    const { scaleToMm: before } = this.source;
    const moved = this.centre_.chosenMm?.map((v) => (v * scaleToMm) / before);
    await this.load({ ...this.source, scaleToMm }, /** @type {Point | undefined} */ (moved));
  }

  /** @param {UpAxis} upAxis */
  async turnUp(upAxis) {
    if (!this.source) return;
    this.source = { ...this.source, upAxis };
    await this.client_.setUpAxis(upAxis);
  }

  /**
   * @param {Source} source      becomes the current one if it can be read
   * @param {Point} [centreMm]  of the code on it; none: the one that the module proposes
   */
  async load(source, centreMm) {
    this.onReplacing_();
    await this.jobs_.untilIdle();
    this.messages_.clearError();
    const axisBefore = this.source?.upAxis ?? 'z';
    try {
      if (source.upAxis !== axisBefore) await this.client_.setUpAxis(source.upAxis);
      this.info = await this.read_(source);
      this.source = { ...source, scaleToMm: this.info.scaleToMm, unitStated: source.scaleToMm === 0 };
      this.centre_.put(centreMm);
    } catch (thrown) {
      this.show_();
      this.onFailed_();
      if (source.upAxis !== axisBefore && !isReplaced(thrown)) await this.client_.setUpAxis(axisBefore);
      throw thrown;
    }
    this.show_();
    await this.onLoaded_();
  }

  /** Gives a new module the model of the last. */
  async reload() {
    if (!this.source) return;
    await this.client_.setUpAxis(this.source.upAxis);
    this.info = await this.read_(this.source);
  }

  /** @param {Source} source */
  read_({ bytes, fileName, scaleToMm }) {
    return this.jobs_.run(() => text('page.reading', { file: fileName }), (signal) =>
      this.client_.loadModel(bytes, fileName, scaleToMm, { signal }));
  }

  /** The file's name, numbers and findings; after a failure those of the model that stays. */
  show_() {
    if (this.source && this.info) this.panel_.show(this.info, this.source);
  }
}
