// SPDX-License-Identifier: GPL-3.0-or-later
// Ties the panels, the view, the parts of the session and the engine together.
import { EngineClient } from './engine/client.js';
import { EngineFailure, describeThrown, internal } from './engine/engine_error.js';
import { message } from './engine/message.js';
import { holdsSecret } from './contents/secrets.js';
import { Continuing } from './session/continuing.js';
import { Database } from './storage/database.js';
import { LastWork } from './storage/last_work.js';
import { prepareReader } from './decoder/reader.js';
import { Carving } from './session/carving.js';
import { Centre } from './session/centre.js';
import { fetchJson } from './session/fetch_file.js';
import { Inspecting } from './session/inspecting.js';
import { Jobs } from './session/jobs.js';
import { ModelSession } from './session/model_session.js';
import { Placing } from './session/placing.js';
import { Preparing } from './session/preparing.js';
import { Recovery } from './session/recovery.js';
import { SpotFinding } from './session/spot_finding.js';
import { Undo } from './session/undo.js';
import { settingsByHandles } from './session/work.js';
import { rememberFormat } from './export/format_choice.js';
import { looksLikeSettings } from './export/settings_file.js';
import { ExportPanel } from './ui/export_panel.js';
import { Exporting } from './session/exporting.js';
import { text } from './i18n/catalogue.js';
import { CarvePanel } from './ui/carve_panel.js';
import { CodePanel } from './ui/code_panel.js';
import { byId } from './dom/dom.js';
import { HelpSheet } from './ui/help_sheet.js';
import { Messages } from './ui/messages.js';
import { ModelPanel } from './ui/model_panel.js';
import { PlacePanel } from './ui/place_panel.js';
import { Theme, offerLanguages } from './ui/preferences.js';
import { ResultPanel } from './ui/result_panel.js';
import { SettingsForm } from './ui/settings_form.js';
import { SpotsPanel } from './ui/spots_panel.js';
import { controlName, shownValue } from './ui/verdict_lines.js';
import { ViewToolbar } from './ui/view_toolbar.js';
import { WorkPanel } from './ui/work_panel.js';
import { InspectorView } from './view/inspector_view.js';
import { Legend } from './view/legend.js';
import { View } from './view/view.js';
import { ViewTools } from './view/view_tools.js';

const kAsked = ['sample', 'text', 'engrave'];  // in the address

export class App {
  /** @param {import('./ui/notices.js').Notices} notices */
  constructor(notices) {
    offerLanguages();
    rememberFormat(byId('format', HTMLSelectElement));
    this.messages_ = new Messages();
    this.messages_.say(() => text('page.starting'));
    this.recovery_ = new Recovery(this.messages_, () => this.client_.replace());
    this.theme_ = new Theme((dark) => this.guard_(() => this.client_.setTheme(dark)));
    this.view_ = this.makeView_();
    this.inspector_ = this.makeInspector_();
    this.legend_ = new Legend();
    this.tools_ = this.makeTools_();
    this.toolbar_ = this.makeToolbar_();
    this.inspecting_ = new Inspecting({
      client: () => this.client_, view: this.view_, window: this.inspector_, toolbar: this.toolbar_,
      guard: (action) => this.guard_(action),
    });
    this.client_ = new EngineClient({
      makeCanvas: () => this.view_.makeCanvas(),
      onEvent: (event) => {
        if (event.event === 'inspector') this.inspector_.update(event.state);
        else void this.guard_(() => this.recovery_.recoverFrom(event));
      },
      onView: (state) => this.tools_.update(state),
      onReplaced: () => this.guard_(() => this.restore_()),
    });
    this.form_ = new SettingsForm((id) => this.guard_(() => this.changeSettings_(id)));
    this.code_ = this.makeCode_();
    this.initialText_ = this.code_.text;
    this.workPanel_ = new WorkPanel({ onEngrave: () => this.guard_(() => this.engrave_()), onCancel: () => this.jobs_.cancel() });
    this.carvePanel_ = new CarvePanel();
    this.jobs_ = new Jobs({ panel: this.workPanel_, messages: this.messages_, onBusy: (busy) => this.allowWork_(!busy) });
    this.placePanel_ = new PlacePanel((centreMm) => this.guard_(() => this.placing_.move(() => this.client_.setCentre(centreMm))));
    this.centre_ = new Centre((mm) => this.placePanel_.showCentre(mm));
    this.model_ = this.makeModel_();
    this.preparing_ = new Preparing({
      client: this.client_, prepareReader, isBusy: () => this.jobs_.busy, user: window,
      isOverModel: ({ target }) => target instanceof HTMLCanvasElement,
    });
    this.placing_ = this.makePlacing_();
    this.spotsPanel_ = this.makeSpotsPanel_();
    this.spots_ = this.makeSpotFinding_();
    this.carving_ = this.makeCarving_();
    this.exportPanel_ = this.makeExportPanel_();
    this.exporting_ = this.makeExporting_();
    this.kept_ = this.makeContinuing_(notices);
    this.undo_ = this.makeUndo_();
    this.help_ = new HelpSheet();
    byId('start-over', HTMLButtonElement).addEventListener('click', () => this.guard_(() => this.startOver_()));
    /** @type {Promise<boolean>} */ this.started_ = Promise.resolve(false);
    this.fileChosen_ = false;
  }

  makeView_() {
    return new View(byId('view', HTMLElement), {
      onAct: (action) => this.tools_.act(action),
      onPick: (x, y) => this.pick_(x, y),
      onHover: (x, y) => this.tools_.hover(x, y),
      onHoverEnd: () => this.tools_.endHover(),
      onTurn: (notches, x, y) => this.tools_.turn(notches, x, y),
      onBefore: (held) => this.toolbar_.hold(held),
      onResize: (size) => this.guard_(() => this.resize_(size)),
    });
  }

  makeInspector_() {
    return new InspectorView(byId('stage', HTMLElement), byId('view', HTMLElement), {
      onAct: (action) => this.guard_(() => this.client_.act(action)),
      onEngrave: (overrides) => this.guard_(() => this.carving_.engrave(overrides)),
    });
  }

  makeTools_() {
    return new ViewTools({
      client: () => this.client_,
      stage: byId('view', HTMLElement),
      overlays: byId('view-overlays', HTMLElement),
      onEdit: {
        onPlace: (x, y) => this.pick_(x, y),
        onAdjust: (change) => this.form_.change(settingsByHandles(change, this.form_.values)),
        onCancel: () => this.guard_(() => this.placing_.place()),
      },
      onAct: (action) => this.guard_(() => this.client_.act(action)),
    });
  }

  /** @param {number} x @param {number} y */
  pick_(x, y) {
    return this.guard_(() => this.placing_.move(() => this.client_.pick(x, y)));
  }

  makeToolbar_() {
    return new ViewToolbar({
      onCarved: (carved) => this.guard_(() => this.showCarved_(carved)),
      onBefore: (before) => this.guard_(() => this.client_.showCarved(!before)),
      onReaderView: () => this.tools_.act({ kind: 'readerView' }),
      onFit: () => this.tools_.act({ kind: 'fit' }),
      onStandard: (name) => this.tools_.act({ kind: 'standard', name }),
      onSection: (shown, offset) => this.guard_(() => this.client_.showSection(shown, offset)),
      onFaceSection: () => this.tools_.act({ kind: 'faceSection' }),
      onDepths: (shown) => this.guard_(() => this.showDepths_(shown)),
      onInspector: (shown) => this.guard_(() => this.inspecting_.show(shown)),
    });
  }

  makeCode_() {
    return new CodePanel({
      onChange: () => this.guard_(() => this.changeSettings_('text')),
      settings: (content) => this.form_.settings(content),
      symbolOf: (settings) => this.client_.symbol(settings),
    });
  }

  makeModel_() {
    const panel = new ModelPanel({
      onSample: (id) => this.guard_(() => this.model_.openSample(id)),
      onFile: (file) => this.guard_(() => this.openFile_(file)),
      onScale: (scaleToMm) => this.guard_(() => this.model_.rescale(scaleToMm)),
      onUpAxis: (upAxis) => this.guard_(() => this.turnUp_(upAxis)),
    });
    return new ModelSession({
      client: this.client_, jobs: this.jobs_, messages: this.messages_, panel, centre: this.centre_,
      onReplacing: () => this.carving_.abort(),
      onLoaded: () => this.useModel_(),
      onFailed: () => this.allowWork_(true),
    });
  }

  makePlacing_() {
    return new Placing({
      client: this.client_, model: this.model_, centre: this.centre_, messages: this.messages_, panel: this.placePanel_,
      settings: () => this.settings_(),
      mayMove: () => !this.jobs_.busy,
      onMoved: () => this.guard_(() => this.leaveCarved_()),
      onPlaced: (placement) => {
        this.toolbar_.setPlaced(placement !== undefined);
        this.tools_.set({ placed: placement !== undefined });
        this.code_.showPlaced(placement);
        this.preparing_.note(placement !== undefined);
        this.exportPanel_.setSecret(holdsSecret(this.code_.text));
      },
    });
  }

  makeSpotsPanel_() {
    return new SpotsPanel({
      onSuggest: () => this.guard_(async () => {
        await this.code_.settle();  // it would end the search
        await this.spots_.suggest();
      }),
      onSpot: (index) => this.guard_(() => this.spots_.choose(index)),
      onSizes: (shown) => this.guard_(() => this.showSizes_(shown)),
    }, this.legend_);
  }

  makeSpotFinding_() {
    return new SpotFinding({
      client: this.client_, jobs: this.jobs_, model: this.model_, placing: this.placing_, messages: this.messages_,
      panel: this.spotsPanel_,
      settings: () => this.settings_(),
      onSizes: () => this.guard_(() => this.carving_.show(false)),
    });
  }

  makeCarving_() {
    const panel = new ResultPanel({
      onDownload: (format) => this.guard_(() => this.carving_.download(format)),
      onSaveReport: () => this.guard_(() => this.carving_.saveReport()),
      onRemedy: (remedy, label) => this.guard_(() => this.remedy_(remedy, label)),
      onTryViews: async (...options) => {
        /** @type {import('./verdict/view_trials.js').Trials | undefined} */ let trials;
        await this.guard_(async () => {
          trials = await this.carving_.tryViews(...options);
        });
        return trials;
      },
    });
    return new Carving({
      client: this.client_, jobs: this.jobs_, model: this.model_, placing: this.placing_, messages: this.messages_, panel,
      work: () => this.work_(),
      settings: () => this.settings_(),
      write: (values) => this.write_({ text: this.code_.text, values }),
      onStart: () => this.spotsPanel_.setSizesShown(false),
      onDone: () => this.undo_.record(),
      onShown: (exists, shown) => this.noteCarved_(exists, shown),
    });
  }

  makeExportPanel_() {
    return new ExportPanel({
      onPicture: () => this.guard_(() => this.exporting_.savePicture()),
      onSettings: () => this.guard_(async () => this.exporting_.saveSettings()),
      onSymbol: (format) => this.guard_(() => this.exporting_.saveSymbol(format)),
    });
  }

  makeExporting_() {
    return new Exporting({
      client: this.client_, model: this.model_, centre: this.centre_, placing: this.placing_, messages: this.messages_,
      settings: () => this.settings_(),
      onSettings: (values, content) => this.write_({ text: content, values }),
      onChanged: () => this.changeSettings_(),
      untilIdle: () => this.becomeIdle_(),
    });
  }

  /** @param {import('./ui/notices.js').Notices} notices */
  makeContinuing_(notices) {
    return new Continuing({
      last: new LastWork(new Database(), holdsSecret), notices,
      current: () => this.currentWork_(),
      onContinue: (work) => this.guard_(() => this.continueWith_(work)),
    });
  }

  /** @returns {import('./storage/last_work.js').Work | undefined} */
  currentWork_() {
    const { source } = this.model_;
    if (!source) return undefined;
    const { bytes, sampleId, fileName, scaleToMm, upAxis } = source;
    const place = { fileName, scaleToMm, upAxis, centreMm: this.centre_.chosenMm };
    return { ...(sampleId ? { sampleId } : { bytes }), ...place, text: this.code_.text, values: this.form_.values };
  }

  /** @param {import('./storage/last_work.js').Work} work */
  async continueWith_({ text: content, values, sampleId, bytes, ...place }) {
    this.write_({ text: content ?? this.code_.text, values });
    const { centreMm, ...file } = place;
    if (sampleId) await this.model_.openSample(sampleId, place);
    else if (bytes) await this.model_.load({ ...file, bytes, credit: '' }, centreMm);
  }

  makeUndo_() {
    return new Undo({
      client: this.client_, jobs: this.jobs_, model: this.model_, placing: this.placing_, spots: this.spots_,
      carving: this.carving_, messages: this.messages_,
      work: () => this.work_(),
      write: (state) => this.write_(state),
      guard: (action) => this.guard_(action),
      onRestored: () => this.kept_.note(),
    });
  }

  /** @returns {import('./session/work.js').Work} */
  work_() {
    const { mm: centreMm, isGuess: centreIsGuess } = this.centre_;
    return { source: this.model_.source, text: this.code_.text, values: this.form_.values, centreMm, centreIsGuess };
  }

  /** Into the controls, without any effect yet. @param {Pick<import('./session/work.js').Work, 'text' | 'values'>} state */
  write_({ text: content, values }) {
    this.code_.text = content;
    this.form_.values = values;
    this.carvePanel_.show();
  }

  settings_() {
    return this.form_.settings(this.code_.text);
  }

  /** @param {URLSearchParams} address */
  async start(address) {
    const started = this.startEngine_(address);
    this.started_ = started;
    if (!(await started)) return;
    if (this.fileChosen_) {  // by who was quicker than the module
      await this.kept_.begin(false);
      return;
    }
    await this.guard_(async () => {
      await this.model_.openSample(address.get('sample') ?? undefined);
      await this.kept_.begin(!kAsked.some((name) => address.has(name)));  // who asked for something gets that
      if (address.get('engrave') === '1') await this.carving_.engrave();
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
      if (problems.length > 0) {
        throw new EngineFailure(internal(message('no-graphics', { why: { cause: problems[0] } })));
      }
      this.model_.setSamples(samples);
    } catch (thrown) {
      this.messages_.say(() => text('page.notStarted'));
      this.messages_.showError(describeThrown(thrown));
      return false;
    }
    this.view_.announceSize();
    await this.client_.setTheme(this.theme_.dark);
    return true;
  }

  /** @param {File} file */
  async openFile_(file) {
    this.fileChosen_ = true;
    if (!(await this.started_)) return;  // it was said why not
    if (looksLikeSettings(file)) await this.useSettings_(file);
    else await this.model_.openFile(file);
  }

  /** @param {File} file */
  async useSettings_(file) {
    if (!this.model_.source) await this.model_.openSample();
    await this.undo_.asOne(() => this.exporting_.useSettings(file));
  }

  /** Ends what is being carved. */
  async becomeIdle_() {
    this.carving_.abort();
    await this.jobs_.untilIdle();
  }

  async engrave_() {
    if (this.code_.incomplete) this.code_.reveal();
    else await this.carving_.engrave();
  }

  /** @param {import('./engine/types.js').UpAxis} upAxis */
  async turnUp_(upAxis) {
    await this.model_.turnUp(upAxis);
    await this.changeSettings_();
  }

  /** A model was loaded. @returns {Promise<void>} */
  useModel_() {
    return this.undo_.asOne(async () => {
      await this.carving_.drop();
      this.allowWork_(true);
      this.spotsPanel_.clear();
      this.kept_.note();
      await this.placing_.begin();
    });
  }

  /** @param {string} [field]  that was edited */
  async changeSettings_(field) {
    this.kept_.note();
    this.messages_.clearError();
    this.code_.refresh();
    this.undo_.record(field);
    this.carving_.compare();
    await this.spots_.forget();
    await this.placing_.place();
  }

  /** @param {import('./verdict/remedies.js').Remedy} remedy @param {string} label */
  async remedy_(remedy, label) {
    if (remedy.kind === 'spot') return this.spots_.suggest();
    this.write_({ text: this.code_.text, values: { ...this.form_.values, [remedy.control]: remedy.value } });
    await this.changeSettings_();
    if (!this.placing_.placement) return undefined;  // it was said why not
    return this.messages_.say(() => text('check.done',
      { label, control: controlName(remedy.control), value: shownValue(remedy.control, remedy.value) }));
  }

  /** The centre was moved: what was carved is elsewhere. */
  async leaveCarved_() {
    this.kept_.note();
    this.undo_.record('centre');
    this.carving_.compare();
    this.spotsPanel_.mark();
    await this.carving_.show(false);
  }

  /** As the page was opened, which can be undone. */
  async startOver_() {
    this.jobs_.abort();
    await this.undo_.asOne(async () => {
      this.write_({ text: this.initialText_, values: this.form_.defaults });
      await this.model_.openSample();
    });
  }

  /** @param {boolean} shown */
  async showSizes_(shown) {
    if (shown) await this.carving_.show(false);
    await this.client_.showSizes(shown);
  }

  /** @param {boolean} carved */
  async showCarved_(carved) {
    if (carved) this.spotsPanel_.setSizesShown(false);
    await this.carving_.show(carved);
  }

  /** @param {boolean} exists @param {boolean} shown  the carved model */
  noteCarved_(exists, shown) {
    this.toolbar_.setCarved(exists, shown);
    this.tools_.reader.show(shown ? this.carving_.carved?.reading.text : undefined);
    this.tools_.set({ carved: shown });
    if (!shown) this.legend_.hide('depths');
    else if (this.toolbar_.depthsShown) void this.guard_(() => this.showDepths_(true));
  }

  /** @param {boolean} shown  the depths of the carved model, as colours */
  async showDepths_(shown) {
    const topMm = await this.client_.showDepths(shown);
    if (shown) this.legend_.show('depths', topMm);
    else this.legend_.hide('depths');
    if (shown && !this.carving_.shown) await this.showCarved_(true);
  }

  /** @param {import('./engine/types.js').ViewSize} size */
  async resize_(size) {
    await this.client_.resize(size);
    await this.inspecting_.makeRoom();
  }

  /** @param {boolean} allowed  if the model can be engraved */
  allowWork_(allowed) {
    const possible = allowed && this.model_.engravable;
    this.undo_.allow();
    this.workPanel_.allowEngrave(possible);
    this.spotsPanel_.allow(possible);
    this.tools_.set({ engravable: this.model_.engravable, busy: !allowed });
  }

  /** Gives a new module what the last one knew. */
  async restore_() {
    await this.carving_.dropForGood();
    this.view_.announceSize();
    await this.client_.setTheme(this.theme_.dark);
    await this.inspecting_.restore();
    this.messages_.say(() => text('page.chooseModel'));
    await this.model_.reload();
    if (!this.model_.source) return;
    this.allowWork_(true);
    this.spotsPanel_.clear();
    await this.placing_.begin();
  }

  /** @param {() => Promise<unknown>} action */
  guard_(action) {
    return this.recovery_.guard(action);
  }
}
