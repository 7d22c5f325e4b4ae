// SPDX-License-Identifier: GPL-3.0-or-later
// Ties the panels, the view and the engine together. It keeps the model's file, the settings and the centre, so that a
// module that had to be replaced can be given everything again.
import { EngineClient, isReplaced } from './engine/client.js';
import { EngineFailure, describeThrown, isFatal } from './engine/engine_error.js';
import { kReaderName, readCode } from './reader/reader.js';
import { text } from './text/catalogue.js';
import { CodePanel } from './ui/code_panel.js';
import { saveFile } from './ui/save_file.js';
import { Messages } from './ui/messages.js';
import { ModelPanel } from './ui/model_panel.js';
import { ResultPanel } from './ui/result_panel.js';
import { SpotsPanel } from './ui/spots_panel.js';
import { ViewToolbar } from './ui/view_toolbar.js';
import { WorkPanel } from './ui/work_panel.js';
import { byId } from './ui/dom.js';
import { View } from './view/view.js';

/** @typedef {import('./engine/types.js').ModelInfo} ModelInfo */
/** @typedef {import('./engine/types.js').ViewSize} ViewSize */
/** @typedef {import('./ui/model_panel.js').Sample} Sample */
/** @typedef {[number, number, number]} Point */
/** @typedef {{ bytes: Uint8Array, fileName: string, scaleToMm: number, upAxis: import('./engine/types.js').UpAxis,
 *   sampleId?: string, credit: string, centreMm?: Point, unitStated?: boolean }} Source
 * `scaleToMm` of 0 leaves the unit to the file, and the true one is put in its place; `unitStated`: that was done */

const kAskForCentre = 'Click the model where the code should go.';
const kMaxFileBytes = 512 * 1024 * 1024;  // beyond it a tab runs out of memory before it can say so
const kGraphicsHint = 'Use a current browser with hardware acceleration switched on';
const kMaxReplacements = 3;               // by faults, before the page gives up

const darkScheme = matchMedia('(prefers-color-scheme: dark)');

export class App {
  constructor() {
    this.messages_ = new Messages();
    this.models_ = new ModelPanel({
      onSample: (id) => this.guard_(() => this.openSample(id)),
      onFile: (file) => this.guard_(() => this.openFile_(file)),
      onScale: (scaleToMm) => this.guard_(() => this.rescale_(scaleToMm)),
      onUpAxis: (upAxis) => this.guard_(() => this.turnUp_(upAxis)),
    });
    this.code_ = new CodePanel({
      onSettings: () => this.guard_(() => this.changeSettings_()),
      onCentre: (centreMm) => this.guard_(() => this.moveCentre_(() => this.client_.setCentre(centreMm))),
    });
    this.spots_ = new SpotsPanel({
      onSuggest: () => this.guard_(() => this.suggestSpots_()),
      onSpot: (index) => this.guard_(() => this.chooseSpot_(index)),
      onSizes: (shown) => this.guard_(() => this.showSizes_(shown)),
    });
    this.work_ = new WorkPanel({ onEngrave: () => this.guard_(() => this.engrave()), onCancel: () => this.cancel_() });
    this.result_ = new ResultPanel({
      onDownload: (format) => this.guard_(() => this.download_(format)),
      onSaveReport: () => this.guard_(() => this.saveReport_()),
    });
    this.toolbar_ = new ViewToolbar({
      onCarved: (carved) => this.guard_(() => this.showCarved_(carved)),
      onReaderView: () => this.guard_(() => this.client_.act({ kind: 'readerView' })),
      onFit: () => this.guard_(() => this.client_.act({ kind: 'fit' })),
      onInspector: (shown) => this.guard_(() => this.showInspector_(shown)),
    });
    this.view_ = new View(byId('view', HTMLElement), {
      onAct: (action) => this.guard_(() => this.client_.act(action)),
      onPick: (x, y) => this.guard_(() => this.moveCentre_(() => this.client_.pick(x, y))),
      onResize: (size) => this.guard_(() => this.client_.resize(size)),
    });
    this.client_ = new EngineClient({
      makeCanvas: () => this.view_.makeCanvas(),
      onEvent: (event) => this.guard_(() => this.recoverFrom_(event)),
      onReplaced: () => this.guard_(() => this.restore_()),
    });
    /** @type {Sample[]} */ this.samples_ = [];
    /** @type {Source | undefined} */ this.source_ = undefined;
    /** @type {ModelInfo | undefined} */ this.model_ = undefined;
    /** @type {Point | undefined} */ this.centreMm_ = undefined;
    /** @type {AbortController | undefined} */ this.workAbort_ = undefined;
    /** @type {Promise<boolean>} */ this.started_ = Promise.resolve(false);
    this.chosen_ = false;
    /** @type {Promise<unknown> | undefined} */ this.running_ = undefined;
    /** @type {Promise<void> | undefined} */ this.placing_ = undefined;
    this.centreIsGuess_ = false;  // the module's, not the user's: no error if the code has no place there
    this.placeAgain_ = false;
    this.placed_ = false;
    this.carvedExists_ = false;
    this.engraving_ = false;
    this.suggesting_ = false;
    this.replacements_ = 0;
    this.recovering_ = false;
  }

  /** @param {URLSearchParams} address */
  async start(address) {
    const started = this.startEngine_(address);
    this.started_ = started;
    if (!(await started) || this.chosen_) return;  // who was quicker than the module has chosen a model already
    await this.guard_(async () => {
      await this.openSample(address.get('sample') ?? this.samples_[0].id);
      if (address.get('engrave') === '1') await this.engrave();
    });
  }

  /**
   * @param {URLSearchParams} address
   * @returns {Promise<boolean>}  whether it runs
   */
  async startEngine_(address) {
    this.code_.text = address.get('text') ?? this.code_.text;
    try {
      const [{ problems }, samples] = await Promise.all([this.client_.start(), fetchJson('samples/manifest.json')]);
      if (problems.length > 0) throw new EngineFailure({ code: 'NoGraphics', message: problems.join('; '), hint: kGraphicsHint });
      this.samples_ = samples;
    } catch (thrown) {
      this.messages_.say('QRelief could not start.');
      this.messages_.showError(describeThrown(thrown));
      return false;
    }
    this.models_.setSamples(this.samples_);
    this.view_.announceSize();
    await this.followTheme_();
    return true;
  }

  async followTheme_() {
    darkScheme.addEventListener('change', () => this.guard_(() => this.client_.setTheme(darkScheme.matches)));
    await this.client_.setTheme(darkScheme.matches);
  }

  /** @param {string} id */
  async openSample(id) {
    const sample = this.samples_.find((known) => known.id === id);
    if (!sample) {
      const names = this.samples_.map((known) => known.id).join(', ');
      this.messages_.showError({ message: `There is no sample “${id}”`, hint: `The samples are ${names}` });
      return;
    }
    const bytes = await fetchBytes(`samples/${sample.file}`);
    await this.load_({ bytes, fileName: sample.file, scaleToMm: 1, upAxis: 'z', sampleId: id, credit: sample.credit, centreMm: sample.centreMm });
  }

  async engrave() {
    if (this.engraving_ || this.workAbort_ || !this.model_?.engravable) return;
    this.engraving_ = true;
    try {
      this.messages_.clearError();
      this.centreIsGuess_ = false;  // from here on an error is worth saying
      await this.place_();
      if (this.placed_) await this.runWork_('Preparing', (signal) => this.engraveNow_(signal));
    } finally {
      this.engraving_ = false;
    }
  }

  /** Looks for the best spots for the settings and shows them to choose from. */
  async suggestSpots_() {
    if (this.workAbort_ || !this.model_?.engravable) return;
    this.messages_.clearError();
    this.spots_.clear();
    await this.client_.configure(this.code_.settings());
    this.suggesting_ = true;
    try {
      const found = await this.runWork_('Looking for spots', (signal) =>
        this.client_.findSpots({ signal, onProgress: (progress) => this.showProgress_(progress) }));
      this.setCarvedShown_(false);
      if (found) this.spots_.show(found);
      this.messages_.say(found ? 'Choose a spot, or click the model.' : 'Cancelled.');
    } finally {
      this.suggesting_ = false;
    }
  }

  /** @param {number} index */
  async chooseSpot_(index) {
    await this.moveCentre_(() => this.client_.chooseSpot(index));
    this.spots_.mark(index);
    if (this.placed_) await this.client_.act({ kind: 'face' });
  }

  /** @param {import('./engine/types.js').EngraveProgress} progress */
  showProgress_(progress) {
    this.work_.update(progress);
    this.messages_.say(`${progress.stage}…`);
  }

  /** @param {AbortSignal} signal */
  async engraveNow_(signal) {
    const started = performance.now();
    this.result_.hide();
    this.setCarved_(false);
    this.spots_.setSizesShown(false);
    const finished = await this.client_.engrave({
      signal,
      onProgress: (progress) => this.showProgress_(progress),
    });
    if (finished) await this.showResult_(started);
    else this.messages_.say(text('page.cancelled'));
  }

  /** @param {number} started */
  async showResult_(started) {
    this.setCarved_(true);
    this.messages_.say('Reading the code back…');
    const readBack = await readCode(await this.client_.readerImage());
    await this.client_.setReadBack(readBack, kReaderName);
    this.result_.show(await this.client_.report(), readBack, performance.now() - started);
    this.result_.scrollIntoView();
    this.messages_.say('Engraved. The model is ready to download.');
  }

  /** @param {File} file */
  async openFile_(file) {
    this.chosen_ = true;
    if (!(await this.started_)) return;  // said why
    if (file.size > kMaxFileBytes) {
      this.messages_.showError({
        message: `${file.name} has ${Math.round(file.size / 2 ** 20)} MiB; this page opens up to ${kMaxFileBytes / 2 ** 20} MiB`,
        hint: 'Save it as binary STL, reduce it, or use the qrelief command',
      });
      return;
    }
    const bytes = new Uint8Array(await file.arrayBuffer());
    const { upAxis } = this.models_;  // the last ones chosen: parts of one origin share them
    const scaleToMm = /\.3mf$/i.test(file.name) ? 0 : this.source_?.unitStated ? 1 : this.models_.scaleToMm;
    await this.load_({ bytes, fileName: file.name, scaleToMm, upAxis, credit: '' });
  }

  /** @param {number} scaleToMm */
  async rescale_(scaleToMm) {
    if (!this.source_) return;
    const { scaleToMm: before, centreMm } = this.source_;
    const moved = centreMm && /** @type {Point} */ (centreMm.map((v) => (v * scaleToMm) / before));
    await this.load_({ ...this.source_, scaleToMm, centreMm: moved });
  }

  /** @param {import('./engine/types.js').UpAxis} upAxis */
  async turnUp_(upAxis) {
    if (!this.source_) return;
    this.source_ = { ...this.source_, upAxis };
    await this.client_.setUpAxis(upAxis);
    await this.changeSettings_();
  }

  /** @param {Source} source  becomes the current one if it can be read */
  async load_(source) {
    if (this.engraving_) this.workAbort_?.abort();
    await this.untilIdle_();
    this.messages_.clearError();
    const axisBefore = this.source_?.upAxis ?? 'z';
    try {
      if (source.upAxis !== axisBefore) await this.client_.setUpAxis(source.upAxis);
      const model = await this.runWork_(`Reading ${source.fileName}`, (signal) =>
        this.client_.loadModel(source.bytes, source.fileName, source.scaleToMm, { signal }));
      this.source_ = { ...source, scaleToMm: model.scaleToMm, unitStated: source.scaleToMm === 0 };
      this.model_ = model;
      this.centreMm_ = source.centreMm;
    } catch (thrown) {
      if (source.upAxis !== axisBefore) await this.client_.setUpAxis(axisBefore);
      this.showSource_();
      this.allowWork_(this.model_?.engravable ?? false);
      throw thrown;
    }
    this.result_.hide();
    this.setCarved_(false);
    this.showSource_();
    await this.useModel_();
  }

  /** The file's name, numbers and findings; after a failure those of the model that stays. */
  showSource_() {
    if (this.source_ && this.model_) this.models_.show(this.model_, this.source_);
  }

  /** Sets the centre in the module's model and places the code there. */
  async useModel_() {
    const { model_: model, centreMm_: centreMm } = this;
    if (!model) return;
    this.allowWork_(model.engravable);
    this.spots_.clear();
    this.showPlacement_(undefined);
    if (!model.engravable) {
      const blocking = model.findings.filter(({ severity }) => severity === 'blocking');
      this.messages_.showError({
        message: blocking.map(({ message }) => message).join('; ') || 'This model cannot be engraved',
        hint: blocking.map(({ hint }) => hint).find((hint) => hint !== '') ?? '',
      });
      this.messages_.say('This model cannot be engraved.');
      return;
    }
    if (centreMm) {
      await this.moveCentre_(() => this.client_.setCentre(centreMm));
    } else if (model.centre) {
      this.centreMm_ = model.centre;
      this.centreIsGuess_ = true;
      this.code_.showCentre(model.centre);
      await this.place_();
    } else {
      this.messages_.say(kAskForCentre);
    }
  }

  async changeSettings_() {
    this.messages_.clearError();
    await this.forgetSpots_();
    this.result_.markOutdated();
    await this.place_();
  }

  /** What was found holds for other settings. */
  async forgetSpots_() {
    if (this.suggesting_) this.workAbort_?.abort();
    if (!this.spots_.known) return;
    this.spots_.clear();
    await this.client_.showSizes(false);
  }

  /** @param {() => Promise<import('./engine/types.js').PickResult>} pick */
  async moveCentre_(pick) {
    if (this.workAbort_ || !this.model_?.engravable) return;
    const { hit, centre } = await pick();
    if (!hit || !centre) return;
    this.messages_.clearError();
    this.result_.markOutdated();
    this.centreMm_ = centre;
    this.centreIsGuess_ = false;
    if (this.source_) this.source_ = { ...this.source_, centreMm: centre };
    this.code_.showCentre(centre);
    this.spots_.mark();
    this.setCarvedShown_(false);
    await this.place_();
  }

  /** Places the code anew; asked again while it runs, it runs once more, with the newest settings. */
  place_() {
    this.placeAgain_ = true;
    this.placing_ ??= this.placeUntilNewest_().finally(() => {
      this.placing_ = undefined;
    });
    return this.placing_;
  }

  async placeUntilNewest_() {
    while (this.placeAgain_) {
      this.placeAgain_ = false;
      if (!this.model_?.engravable) return;
      try {
        await this.client_.configure(this.code_.settings());
        if (this.centreMm_ === undefined) {
          this.messages_.say(kAskForCentre);
          return;
        }
        this.messages_.say('Finding direction and size…');
        this.showPlacement_(await this.client_.placement());
        this.messages_.say(text('page.ready'));
      } catch (thrown) {
        if (isReplaced(thrown) || isFatal(thrown)) throw thrown;
        this.showPlacement_(undefined);
        this.messages_.say(this.centreIsGuess_ ? kAskForCentre : 'The code has no place yet.');
        if (!this.placeAgain_ && !this.centreIsGuess_) this.messages_.showError(thrown instanceof RangeError ? { message: thrown.message, hint: '' } : describeThrown(thrown));
      }
    }
  }

  /** @param {import('./engine/types.js').Placement | undefined} placement */
  showPlacement_(placement) {
    this.placed_ = placement !== undefined;
    this.toolbar_.setPlaced(this.placed_);
    if (placement) this.code_.showPlacement(placement);
    else this.code_.hidePlacement();
  }

  /** @param {boolean} exists  and is shown */
  setCarved_(exists) {
    this.carvedExists_ = exists;
    this.setCarvedShown_(exists);
  }

  /** @param {boolean} shown */
  setCarvedShown_(shown) {
    this.toolbar_.setCarved(this.carvedExists_, shown && this.carvedExists_);
    if (this.carvedExists_) void this.guard_(() => this.client_.showCarved(shown));
  }

  /** @param {boolean} shown */
  async showSizes_(shown) {
    if (shown) this.toolbar_.setCarved(this.carvedExists_, false);
    await this.client_.showSizes(shown);
  }

  /** @param {boolean} carved */
  async showCarved_(carved) {
    if (carved) this.spots_.setSizesShown(false);
    await this.client_.showCarved(carved);
  }

  /** @param {boolean} shown */
  async showInspector_(shown) {
    this.view_.reportsPointer = shown;
    await this.client_.setInspector(shown);
  }

  /** @param {string} format */
  async download_(format) {
    const bytes = await this.client_.exportModel(format);
    const [extension, addition] = format.split('-');
    saveFile(new Blob([bytes], { type: `model/${extension}` }),
      `${this.baseName_()}-qr${addition ? `-${addition}` : ''}.${extension}`);
  }

  async saveReport_() {
    const text = JSON.stringify(await this.client_.report(), null, 2);
    saveFile(new Blob([text], { type: 'application/json' }), `${this.baseName_()}-qr.json`);
  }

  baseName_() {
    return (this.source_?.fileName ?? 'model').replace(/\.[^.]*$/, '');
  }

  cancel_() {
    this.messages_.say('Stopping…');
    this.workAbort_?.abort();
  }

  /**
   * Runs long work with a progress bar and a way to stop it.
   * @template T
   * @param {string} stage
   * @param {(signal: AbortSignal) => Promise<T>} run
   * @returns {Promise<T>}
   */
  async runWork_(stage, run) {
    await this.untilIdle_();
    const abort = new AbortController();
    this.workAbort_ = abort;
    this.work_.begin(stage);
    this.spots_.allow(false);
    this.messages_.say(`${stage}…`);
    const running = run(abort.signal);
    this.running_ = running;
    try {
      return await running;
    } finally {
      this.running_ = undefined;
      this.workAbort_ = undefined;
      this.work_.end();
      this.allowWork_(this.model_?.engravable ?? false);
    }
  }

  /** @param {boolean} allowed */
  allowWork_(allowed) {
    this.work_.allowEngrave(allowed);
    this.spots_.allow(allowed);
  }

  async untilIdle_() {
    while (this.running_) await this.running_.catch(() => {});  // whoever began it hears of its failure
  }

  /** @param {import('./engine/types.js').HostEvent} event */
  async recoverFrom_(event) {
    if (this.recovering_) return;  // one fault is told by every verb that was waiting
    this.recovering_ = true;
    try {
      await this.replaceAfter_(event);
    } finally {
      this.recovering_ = false;
    }
  }

  /** @param {import('./engine/types.js').HostEvent} event */
  async replaceAfter_(event) {
    this.replacements_ += 1;
    if (event.event === 'failure') this.messages_.showError(event.error);
    if (this.replacements_ > kMaxReplacements) {
      this.messages_.say('QRelief has stopped.');
      this.messages_.showError({
        message: 'The engraving module failed again and again',
        hint: 'Reload the page; if it happens with this model only, try one with fewer triangles',
      });
      return;
    }
    this.messages_.say(event.event === 'contextlost' ? 'The graphics were lost; starting again…' : 'Starting again…');
    await this.client_.replace();
  }

  /** Gives a new module what the last one knew. */
  async restore_() {
    this.result_.hide();
    this.setCarved_(false);
    this.view_.announceSize();
    await this.client_.setTheme(darkScheme.matches);
    if (this.toolbar_.inspectorShown) await this.client_.setInspector(true);
    this.messages_.say('Choose a model.');
    if (!this.source_) return;
    const { bytes, fileName, scaleToMm, upAxis } = this.source_;
    await this.client_.setUpAxis(upAxis);
    this.model_ = await this.runWork_(`Reading ${fileName}`, (signal) => this.client_.loadModel(bytes, fileName, scaleToMm, { signal }));
    await this.useModel_();
  }

  /**
   * Runs what a control asked for; whatever is thrown ends as words on the page.
   * @param {() => Promise<unknown>} action
   */
  async guard_(action) {
    try {
      await action();
    } catch (thrown) {
      if (isReplaced(thrown)) return;
      const error = describeThrown(thrown);
      this.messages_.showError(error);
      this.messages_.say('That did not work.');
      if (isFatal(thrown)) await this.recoverFrom_({ event: 'failure', error });
    }
  }
}

/** @param {string} path  relative to the page */
async function fetchOk(path) {
  const response = await fetch(path);
  if (!response.ok) throw new Error(`${path} could not be fetched (status ${response.status})`);
  return response;
}

/** @param {string} path */
const fetchJson = async (path) => (await fetchOk(path)).json();

/** @param {string} path */
const fetchBytes = async (path) => new Uint8Array(await (await fetchOk(path)).arrayBuffer());
