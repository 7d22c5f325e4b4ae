// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates the page: model, settings and result, from load to reload.
import { EngineFailure, describeThrown, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { looksLikeSettings } from '../export/settings_file.js';
import { text } from '../i18n/catalogue.js';
import { controlName, shownValue } from '../ui/verdict_lines.js';
import { looksLikeList } from './batching.js';
import { fetchJson } from './fetch_file.js';

const kAsked = ['sample', 'text', 'engrave']; // address parameters

/**
 * @typedef {object} Parts
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('../view/view.js').View} view
 * @property {import('../ui/preferences.js').Theme} theme
 * @property {import('../view/legend.js').Legend} legend
 * @property {import('../view/view_tools.js').ViewTools} tools
 * @property {import('../ui/view_toolbar.js').ViewToolbar} toolbar
 * @property {import('./inspecting.js').Inspecting} inspecting
 * @property {import('../ui/settings_form.js').SettingsForm} form
 * @property {import('../ui/code_panel.js').CodePanel} code
 * @property {import('../ui/work_panel.js').WorkPanel} workPanel
 * @property {import('../ui/carve_panel.js').CarvePanel} carvePanel
 * @property {import('./jobs.js').Jobs} jobs
 * @property {import('../ui/messages.js').Messages} messages
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./centre.js').Centre} centre
 * @property {import('./placing.js').Placing} placing
 * @property {import('../ui/spots_panel.js').SpotsPanel} spotsPanel
 * @property {import('./spot_finding.js').SpotFinding} spots
 * @property {import('./carving.js').Carving} carving
 * @property {import('./batching.js').Batching} batching
 * @property {import('./batch_carving.js').BatchCarving} batchCarving
 * @property {import('../ui/batch_panel.js').BatchPanel} batchPanel
 * @property {import('./exporting.js').Exporting} exporting
 * @property {import('./continuing.js').Continuing} kept
 * @property {import('./undo.js').Undo} undo
 * @property {import('./recovery.js').Recovery} recovery
 */

export class Session {
  /** @param {Parts} parts */
  constructor(parts) {
    this.parts_ = parts;
    this.initialText_ = parts.code.text;
    /** @type {Promise<boolean>} */ this.started_ = Promise.resolve(false);
    this.fileChosen_ = false;
  }

  /** @returns {import('../storage/last_work.js').Work | undefined} */
  currentWork() {
    const { source } = this.parts_.model;
    if (!source) return undefined;
    const { bytes, sampleId, fileName, scaleToMm, upAxis } = source;
    const place = { fileName, scaleToMm, upAxis, centreMm: this.parts_.centre.chosenMm };
    const { input: batch } = this.parts_.batching;
    return {
      ...(sampleId ? { sampleId } : { bytes }),
      ...place,
      text: this.parts_.code.text,
      values: this.parts_.form.values,
      ...(batch && { batch }),
    };
  }

  /** @param {import('../storage/last_work.js').Work} work */
  async continueWith({ text: content, values, sampleId, bytes, batch, ...place }) {
    this.write({ text: content ?? this.parts_.code.text, values, batch });
    const { centreMm, ...file } = place;
    if (sampleId) await this.parts_.model.openSample(sampleId, place);
    else if (bytes) await this.parts_.model.load({ ...file, bytes, credit: '' }, centreMm);
  }

  /** @returns {import('./work.js').Work} */
  work() {
    const { mm: centreMm, isGuess: centreIsGuess } = this.parts_.centre;
    return {
      source: this.parts_.model.source,
      text: this.parts_.code.text,
      values: this.parts_.form.values,
      centreMm,
      centreIsGuess,
      batch: this.parts_.batching.input,
    };
  }

  /**
   * Writes a state into the controls without applying it. The parts stay as they are if `batch` is absent.
   * @param {Pick<import('./work.js').Work, 'text' | 'values' | 'batch'>} state
   */
  write({ text: content, values, ...state }) {
    this.parts_.code.text = content;
    this.parts_.form.values = values;
    if ('batch' in state) this.parts_.batching.input = state.batch;
    this.parts_.carvePanel.show();
  }

  /** Returns the settings of the current code: the single code or the first part. */
  settings() {
    return this.parts_.batching.settings(this.parts_.code.text);
  }

  /** Returns the same settings after checking the current list. */
  async plannedSettings() {
    await this.parts_.batching.ready();
    return this.settings();
  }

  /** @param {URLSearchParams} address */
  async start(address) {
    const started = this.startEngine_(address);
    this.started_ = started;
    if (!(await started)) return;
    if (this.fileChosen_) {
      // the user opened a file before the module was ready
      await this.parts_.batchCarving.offer();
      await this.parts_.kept.begin(false);
      return;
    }
    await this.guard_(async () => {
      const { asksForSettings, warnings, refusal } = this.parts_.exporting.useAddress(address);
      await this.parts_.model.openSample(address.get('sample') ?? undefined);
      const isOffered = await this.parts_.batchCarving.offer();
      // An address that asks for something takes precedence over the last visit's work.
      await this.parts_.kept.begin(!isOffered && !asksForSettings && !kAsked.some((name) => address.has(name)));
      if (refusal) throw refusal;
      if (address.get('engrave') === '1') await this.parts_.carving.engrave();
      this.parts_.messages.warn(warnings);
    });
  }

  /**
   * @param {URLSearchParams} address
   * @returns {Promise<boolean>}  false: the engine did not start
   */
  async startEngine_(address) {
    this.parts_.code.text = address.get('text') ?? this.parts_.code.text;
    try {
      const [{ problems }, samples] = await Promise.all([
        this.parts_.client.start(),
        fetchJson('samples/manifest.json'),
      ]);
      if (problems.length > 0) {
        throw new EngineFailure(internal(message('no-graphics', { why: { cause: problems[0] } })));
      }
      this.parts_.model.setSamples(samples);
    } catch (thrown) {
      this.parts_.messages.say(() => text('page.notStarted'));
      this.parts_.messages.showError(describeThrown(thrown));
      return false;
    }
    this.parts_.view.announceSize();
    await this.parts_.client.setTheme(this.parts_.theme.dark);
    return true;
  }

  /** @param {File} file */
  async openFile(file) {
    this.fileChosen_ = true;
    if (!(await this.started_)) return; // the page shows why
    if (looksLikeSettings(file)) await this.useSettings_(file);
    else if (looksLikeList(file)) await this.parts_.batching.openList(file);
    else await this.parts_.model.openFile(file);
  }

  /** @param {File} file */
  async useSettings_(file) {
    if (!this.parts_.model.source) await this.parts_.model.openSample();
    this.parts_.undo.keep();
    await this.parts_.undo.asOne(() => this.parts_.exporting.useSettings(file));
  }

  /** Aborts a running carving and waits until no job runs. */
  async becomeIdle() {
    this.parts_.carving.abort();
    await this.parts_.jobs.untilIdle();
  }

  async engrave() {
    await this.parts_.batching.ready();
    if (this.parts_.batching.incomplete) this.parts_.batchPanel.reveal();
    else if (this.parts_.code.incomplete) this.parts_.code.reveal();
    else await this.parts_.carving.engrave();
  }

  /** @param {import('../engine/types.js').UpAxis} upAxis */
  async turnUp(upAxis) {
    await this.parts_.model.turnUp(upAxis);
    await this.changeSettings();
  }

  /** Begins with a newly loaded model. @returns {Promise<void>} */
  useModel() {
    return this.parts_.undo.asOne(async () => {
      await this.parts_.carving.drop();
      this.allowWork(true);
      this.parts_.spotsPanel.clear();
      this.parts_.kept.note();
      await this.parts_.placing.begin();
    });
  }

  /** Applies changed settings. @param {string} [field]  edited field */
  async changeSettings(field) {
    this.parts_.kept.note();
    this.parts_.messages.clearError();
    this.parts_.code.refresh();
    this.parts_.undo.record(field);
    this.parts_.carving.compare();
    this.parts_.batchCarving.show();
    await this.parts_.batching.ready();
    await this.parts_.spots.forget();
    await this.parts_.placing.place();
  }

  /** Applies another list, or the change back to a single code. */
  async changeParts() {
    await this.parts_.batching.ready();
    await this.changeSettings('parts');
  }

  /** Applies a remedy. @param {import('../engine/types.js').Remedy} remedy @param {string} label */
  async remedy({ change }, label) {
    if (!change) return this.parts_.spots.suggest();
    const { id, value } = this.parts_.form.controlFor(change);
    this.write({ text: this.parts_.code.text, values: this.parts_.form.valuesAfter(change) });
    await this.changeSettings();
    if (!this.parts_.placing.placement) return undefined; // the page shows why
    return this.parts_.messages.say(() =>
      text('check.done', { label, control: controlName(id), value: shownValue(id, value) }),
    );
  }

  /** Reacts to a moved centre: the carving is at another place now. */
  async leaveCarved() {
    this.parts_.kept.note();
    this.parts_.undo.record('centre');
    this.parts_.carving.compare();
    this.parts_.batchCarving.show();
    this.parts_.spotsPanel.mark();
    await this.parts_.carving.show(false);
  }

  /** Returns to the state in which the page opened. Can be undone. */
  async startOver() {
    this.parts_.jobs.abort();
    this.parts_.undo.keep();
    await this.parts_.undo.asOne(async () => {
      this.write({ text: this.initialText_, values: this.parts_.form.defaults, batch: undefined });
      await this.parts_.model.openSample();
    });
  }

  /** @param {boolean} shown */
  async showSizes(shown) {
    if (shown) await this.parts_.carving.show(false);
    await this.parts_.client.show({ sizes: shown });
  }

  /** @param {boolean} carved */
  async showCarved(carved) {
    if (carved) this.parts_.spotsPanel.setSizesShown(false);
    await this.parts_.carving.show(carved);
  }

  /** Reacts to a change of the carved model. @param {boolean} exists @param {boolean} shown */
  noteCarved(exists, shown) {
    this.parts_.toolbar.setCarved(exists, shown);
    this.parts_.tools.reader.show(shown ? this.parts_.carving.carved?.report.verification.text : undefined);
    this.parts_.tools.set({ carved: shown });
    this.notePrinted();
    this.parts_.batchCarving.show();
    if (!shown) this.parts_.legend.hide('depths');
    else if (this.parts_.toolbar.depthsShown) void this.guard_(() => this.showDepths(true));
  }

  /** Updates the print in the view after a new carving or print. */
  notePrinted() {
    const { report, printed } = this.parts_.carving.carved ?? {};
    this.parts_.tools.reader.showPrint(
      report && printed?.state === 'made'
        ? {
            print: printed.print,
            modules: report.symbol.modules,
            reads: report.verification.verdict.prints.level !== 'bad',
          }
        : undefined,
    );
  }

  /** Shows or hides the depths as colours on the carved model. @param {boolean} shown */
  async showDepths(shown) {
    const { topMm, deepestMm } = await this.parts_.client.show({ depths: shown });
    if (shown) this.parts_.legend.show('depths', topMm, deepestMm > topMm);
    else this.parts_.legend.hide('depths');
    if (shown && !this.parts_.carving.shown) await this.showCarved(true);
  }

  /** @param {import('../engine/types.js').ViewSize} size */
  async resize(size) {
    await this.parts_.client.resize(size);
    await this.parts_.inspecting.makeRoom();
  }

  /** Enables or disables engraving and the spot search. @param {boolean} allowed  if the model can be engraved */
  allowWork(allowed) {
    const possible = allowed && this.parts_.model.engravable;
    this.parts_.undo.allow();
    this.parts_.workPanel.allowEngrave(possible);
    this.parts_.spotsPanel.allow(possible);
    this.parts_.tools.set({ engravable: this.parts_.model.engravable, busy: !allowed });
  }

  /** Restores the state in a new module. */
  async restore() {
    await this.parts_.carving.dropForGood();
    this.parts_.batching.forget();
    this.parts_.view.announceSize();
    await this.parts_.client.setTheme(this.parts_.theme.dark);
    await this.parts_.inspecting.restore();
    this.parts_.messages.say(() => text('page.chooseModel'));
    await this.parts_.model.reload();
    if (!this.parts_.model.source) return;
    this.allowWork(true);
    this.parts_.spotsPanel.clear();
    await this.parts_.placing.begin();
  }

  /** @param {number} x @param {number} y */
  pick(x, y) {
    return this.guard_(() => this.parts_.placing.move(() => this.parts_.client.setCentre({ at: [x, y] })));
  }

  /** @param {() => Promise<unknown>} action */
  guard_(action) {
    return this.parts_.recovery.guard(action);
  }
}
