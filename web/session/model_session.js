// SPDX-License-Identifier: GPL-3.0-or-later
// Opens models: keeps the source in the work, so that it can be opened again, and holds the module's findings.
import { isReplaced } from '../engine/client.js';
import { text } from '../i18n/catalogue.js';
import { modelName } from '../i18n/model_name.js';
import { fetchBytes } from './fetch_file.js';
import { centredAt, chosenCentre } from './work.js';

/** @typedef {import('../engine/types.js').ModelInfo} ModelInfo */
/** @typedef {import('../engine/types.js').UpAxis} UpAxis */
/** @typedef {import('../ui/model_panel.js').Sample} Sample */
/** @typedef {[number, number, number]} Point */
/** @typedef {{ bytes: Uint8Array, fileName: string, scaleToMm: number, upAxis: UpAxis, sampleId?: string, credit: string,
 *   unitStated?: boolean }} Source
 * `scaleToMm`: 0 takes the unit from the file, and loading replaces it; `unitStated`: the unit came from the file */

/** @typedef {import('../settings/work_settings.js').WorkSettings} WorkSettings */
/** @typedef {(settings: WorkSettings) => WorkSettings} SettingsFor  returns the settings that the new model starts with */

/** @type {SettingsFor} */
const asTheyAre = (settings) => settings;

const kMaxFileBytes = 512 * 1024 * 1024; // a larger file exhausts a tab's memory before the page can report it

/**
 * @typedef {object} ModelOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('./jobs.js').Jobs} jobs
 * @property {import('../ui/messages.js').Messages} messages
 * @property {import('../ui/model_panel.js').ModelPanel} panel
 * @property {import('./work_store.js').WorkStore} store
 * @property {() => void} onReplacing          called before a model is read
 * @property {() => Promise<void>} onLoaded    called with the source and `info` of a new model set
 * @property {() => void} onFailed             called if a model cannot be read; the previous one stays
 */

export class ModelSession {
  /** @param {ModelOptions} options */
  constructor({ client, jobs, messages, panel, store, onReplacing, onLoaded, onFailed }) {
    this.client_ = client;
    this.jobs_ = jobs;
    this.messages_ = messages;
    this.panel_ = panel;
    this.store_ = store;
    this.onReplacing_ = onReplacing;
    this.onLoaded_ = onLoaded;
    this.onFailed_ = onFailed;
    /** @type {Sample[]} */ this.samples_ = [];
    /** @type {ModelInfo | undefined} */ this.info = undefined;
  }

  /** The source of the current model. */
  get source() {
    return this.store_.work.source;
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
   * Opens a sample.
   * @param {string} [id]  default: the first sample
   * @param {Partial<Source> & { centreMm?: Point }} [place]  overrides the sample's values
   * @param {SettingsFor} [settingsFor]
   */
  async openSample(id = this.samples_[0].id, place = {}, settingsFor = asTheyAre) {
    const sample = this.samples_.find((known) => known.id === id);
    if (!sample) {
      const names = this.samples_.map((known) => known.id).join(', ');
      this.messages_.showError({
        found: () => text('page.noSample', { id }),
        help: () => text('page.samplesAre', { names }),
      });
      if (!this.source) this.messages_.say(() => text('page.chooseModel'));
      return;
    }
    const bytes = await fetchBytes(`samples/${sample.file}`).catch(() => undefined);
    if (!bytes) {
      this.messages_.showError({
        found: () => text('page.sampleNotLoaded', { name: modelName({ sampleId: id, fileName: sample.file }) }),
        help: () => text('page.sampleNotLoadedHint'),
      });
      if (!this.source) this.messages_.say(() => text('page.chooseModel'));
      this.show_(); // the chosen name is not the model's
      return;
    }
    const { centreMm, ...instead } = { centreMm: sample.centreMm, ...place };
    await this.load(
      { bytes, fileName: sample.file, scaleToMm: 1, upAxis: 'z', sampleId: id, credit: sample.credit, ...instead },
      centreMm,
      settingsFor,
    );
  }

  /** @param {File} file @param {SettingsFor} [settingsFor] */
  async openFile(file, settingsFor = asTheyAre) {
    if (file.size > kMaxFileBytes) {
      const values = { file: file.name, size: Math.round(file.size / 2 ** 20), limit: kMaxFileBytes / 2 ** 20 };
      this.messages_.showError({ found: () => text('page.tooLarge', values), help: () => text('page.tooLargeHint') });
      return;
    }
    const bytes = new Uint8Array(await file.arrayBuffer());
    const { upAxis } = this.panel_; // last chosen values: files from one source usually share them
    const scaleToMm = /\.(3mf|zip)$/i.test(file.name) ? 0 : this.source?.unitStated ? 1 : this.panel_.scaleToMm;
    await this.load({ bytes, fileName: file.name, scaleToMm, upAxis, credit: '' }, undefined, settingsFor);
  }

  /** @param {number} scaleToMm */
  async rescale(scaleToMm) {
    const { source } = this;
    if (!source) return;
    const moved = chosenCentre(this.store_.work)?.map((v) => (v * scaleToMm) / source.scaleToMm);
    await this.load({ ...source, scaleToMm }, /** @type {Point | undefined} */ (moved));
  }

  /** @param {UpAxis} upAxis */
  async turnUp(upAxis) {
    const { source } = this;
    if (!source) return;
    this.store_.update({ source: { ...source, upAxis } });
    await this.client_.show({ upAxis });
  }

  /**
   * Loads a model.
   * @param {Source} source      becomes the current source if it can be read
   * @param {Point} [centreMm]  centre of the code; default: the module's proposal
   * @param {SettingsFor} [settingsFor]
   */
  async load(source, centreMm, settingsFor = asTheyAre) {
    this.onReplacing_();
    this.jobs_.abortBackground();
    await this.jobs_.untilIdle();
    this.messages_.clearError();
    const axisBefore = this.source?.upAxis ?? 'z';
    try {
      if (source.upAxis !== axisBefore) await this.client_.show({ upAxis: source.upAxis });
      this.info = await this.read_(source);
      const { scaleToMm } = this.info;
      this.store_.update(({ settings }) => ({
        source: { ...source, scaleToMm, unitStated: source.scaleToMm === 0 },
        ...centredAt(centreMm),
        settings: settingsFor(settings),
      }));
    } catch (thrown) {
      this.show_();
      this.onFailed_();
      if (source.upAxis !== axisBefore && !isReplaced(thrown)) await this.client_.show({ upAxis: axisBefore });
      throw thrown;
    }
    this.show_();
    await this.onLoaded_();
  }

  /** Loads the current model into a new module. */
  async reload() {
    if (!this.source) return;
    await this.client_.show({ upAxis: this.source.upAxis });
    this.info = await this.read_(this.source);
  }

  /** @param {Source} source */
  read_({ bytes, fileName, scaleToMm }) {
    return this.jobs_.run(
      () => text('page.reading', { file: fileName }),
      (signal) => this.client_.loadModel(bytes, fileName, scaleToMm, { signal }),
    );
  }

  /** Shows file name, numbers and findings of the current model; after a failure, that is the previous one. */
  show_() {
    if (this.source && this.info) this.panel_.show(this.info, this.source);
  }
}
