// SPDX-License-Identifier: GPL-3.0-or-later
// Creates the panels, the view, the session's parts and the engine, and connects them. The work itself is done
// elsewhere.
import { kSettings } from './generated/settings.js';
import { EngineClient } from './engine/client.js';
import { holdsSecret } from './payloads/secrets.js';
import { Continuing } from './session/continuing.js';
import { Database } from './storage/database.js';
import { Folder } from './storage/folder.js';
import { LastWork } from './storage/last_work.js';
import { prepareReader } from './decoder/reader.js';
import { BatchStore } from './batch/batch_store.js';
import { BatchCarving } from './session/batch_carving.js';
import { Batching, plannedWords } from './session/batching.js';
import { Carving } from './session/carving.js';
import { Centre } from './session/centre.js';
import { Inspecting } from './session/inspecting.js';
import { Jobs } from './session/jobs.js';
import { ModelSession } from './session/model_session.js';
import { Placing } from './session/placing.js';
import { Printing } from './session/printing.js';
import { Preparing } from './session/preparing.js';
import { Recovery } from './session/recovery.js';
import { Session } from './session/session.js';
import { SpotFinding } from './session/spot_finding.js';
import { Undo } from './session/undo.js';
import { settingsByHandles } from './session/work.js';
import { rememberFormat } from './export/format_choice.js';
import { ExportPanel } from './ui/export_panel.js';
import { Exporting } from './session/exporting.js';
import { text } from './i18n/catalogue.js';
import { messageWords } from './i18n/message_words.js';
import { BatchPanel } from './ui/batch_panel.js';
import { CarvePanel } from './ui/carve_panel.js';
import { CodePanel } from './ui/code_panel.js';
import { byId } from './dom/dom.js';
import { HelpSheet } from './ui/help_sheet.js';
import { Messages } from './ui/messages.js';
import { ModelPanel } from './ui/model_panel.js';
import { PartsPanel } from './ui/parts_panel.js';
import { PlacePanel } from './ui/place_panel.js';
import { Theme, offerLanguages } from './ui/preferences.js';
import { ResultPanel } from './ui/result_panel.js';
import { SettingsForm } from './ui/settings_form.js';
import { SpotsPanel } from './ui/spots_panel.js';
import { ViewToolbar } from './ui/view_toolbar.js';
import { WorkPanel } from './ui/work_panel.js';
import { InspectorView } from './view/inspector_view.js';
import { Legend } from './view/legend.js';
import { View } from './view/view.js';
import { ViewTools } from './view/view_tools.js';

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
      client: () => this.client_,
      view: this.view_,
      window: this.inspector_,
      toolbar: this.toolbar_,
      guard: (action) => this.guard_(action),
    });
    this.client_ = new EngineClient({
      makeCanvas: () => this.view_.makeCanvas(),
      onEvent: (event) => {
        if (event.event === 'inspector') this.inspector_.update(event.state);
        else void this.guard_(() => this.recovery_.recoverFrom(event));
      },
      onView: (state) => this.tools_.update(state),
      onSearch: (search) => this.tools_.search.show(search),
      onReplaced: () => this.guard_(() => this.session_.restore()),
    });
    this.form_ = new SettingsForm((id) => this.guard_(() => this.session_.changeSettings(id)));
    this.code_ = this.makeCode_();
    this.batchPanel_ = this.makeBatchPanel_();
    this.batching_ = this.makeBatching_();
    this.workPanel_ = new WorkPanel({
      onEngrave: () => this.guard_(() => this.session_.engrave()),
      onCancel: () => this.jobs_.cancel(),
    });
    this.carvePanel_ = new CarvePanel();
    this.jobs_ = new Jobs({
      panel: this.workPanel_,
      messages: this.messages_,
      onBusy: (busy) => this.session_.allowWork(!busy),
    });
    this.placePanel_ = new PlacePanel((centreMm) =>
      this.guard_(() => this.placing_.move(() => this.client_.setCentre({ mm: centreMm }))),
    );
    this.centre_ = new Centre((mm) => this.placePanel_.showCentre(mm));
    this.model_ = this.makeModel_();
    this.preparing_ = new Preparing({
      client: this.client_,
      prepareReader: () => this.prepareTelling_(),
      isBusy: () => this.jobs_.busy || this.carving_.isPrinting,
      user: window,
      isOverModel: ({ target }) => target instanceof HTMLCanvasElement,
    });
    this.placing_ = this.makePlacing_();
    this.spotsPanel_ = this.makeSpotsPanel_();
    this.spots_ = this.makeSpotFinding_();
    this.carving_ = this.makeCarving_();
    this.partsPanel_ = this.makePartsPanel_();
    this.batchCarving_ = this.makeBatchCarving_(notices);
    this.exportPanel_ = this.makeExportPanel_();
    this.exporting_ = this.makeExporting_();
    this.kept_ = this.makeContinuing_(notices);
    this.undo_ = this.makeUndo_();
    this.help_ = new HelpSheet();
    byId('start-over', HTMLButtonElement).addEventListener('click', () => this.guard_(() => this.session_.startOver()));
    this.session_ = new Session({
      client: this.client_,
      view: this.view_,
      theme: this.theme_,
      legend: this.legend_,
      tools: this.tools_,
      toolbar: this.toolbar_,
      inspecting: this.inspecting_,
      form: this.form_,
      code: this.code_,
      workPanel: this.workPanel_,
      carvePanel: this.carvePanel_,
      jobs: this.jobs_,
      messages: this.messages_,
      model: this.model_,
      centre: this.centre_,
      placing: this.placing_,
      spotsPanel: this.spotsPanel_,
      spots: this.spots_,
      carving: this.carving_,
      batching: this.batching_,
      batchPanel: this.batchPanel_,
      batchCarving: this.batchCarving_,
      exporting: this.exporting_,
      kept: this.kept_,
      undo: this.undo_,
      recovery: this.recovery_,
    });
  }

  makeView_() {
    return new View(byId('view', HTMLElement), {
      onAct: (action) => this.tools_.act(action),
      onPick: (x, y) => this.session_.pick(x, y),
      onHover: (x, y) => this.tools_.hover(x, y),
      onHoverEnd: () => this.tools_.endHover(),
      onTurn: (notches, x, y) => this.tools_.turn(notches, x, y),
      onBefore: (held) => this.toolbar_.hold(held),
      onResize: (size) => this.guard_(() => this.session_.resize(size)),
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
        onPlace: (x, y) => this.session_.pick(x, y),
        onAdjust: (change) => this.form_.change(settingsByHandles(change, this.form_.values)),
        onCancel: () => this.guard_(() => this.placing_.place()),
      },
      onAct: (action) => this.guard_(() => this.client_.act(action)),
    });
  }

  makeToolbar_() {
    return new ViewToolbar({
      onCarved: (carved) => this.guard_(() => this.session_.showCarved(carved)),
      onBefore: (before) => this.guard_(() => this.client_.show({ carved: !before })),
      onReaderView: () => this.tools_.act({ kind: 'readerView' }),
      onFit: () => this.tools_.act({ kind: 'fit' }),
      onStandard: (name) => this.tools_.act({ kind: 'standard', name }),
      onSection: (shown, offset) => this.guard_(() => this.client_.show({ section: shown ? offset : null })),
      onFaceSection: () => this.tools_.act({ kind: 'faceSection' }),
      onDepths: (shown) => this.guard_(() => this.session_.showDepths(shown)),
      onInspector: (shown) => this.guard_(() => this.inspecting_.show(shown)),
    });
  }

  makeCode_() {
    return new CodePanel({
      onChange: () => this.guard_(() => this.session_.changeSettings('text')),
      settings: (content) => (this.batching_?.input ? this.batching_.settings(content) : this.form_.settings(content)),
      symbolOf: (settings) => this.client_.symbol(settings),
    });
  }

  makeBatchPanel_() {
    return new BatchPanel({
      onChange: () => this.guard_(() => this.session_.changeParts()),
      onFile: (file) => this.guard_(() => this.batching_.openList(file)),
    });
  }

  /** @returns {Batching} */
  makeBatching_() {
    return new Batching({
      client: this.client_,
      panel: this.batchPanel_,
      messages: this.messages_,
      settings: (content) => this.form_.settings(content),
      isLocked: () => this.batchCarving_.isOpen,
      onPlanned: (planned) => {
        this.code_.showParts(
          planned && { words: () => plannedWords(planned), isWrong: planned.problems.length > 0, first: planned.first },
        );
        this.workPanel_.nameEngrave(planned ? 'batch.engraveFirst' : 'page.engrave');
        this.batchCarving_.show();
      },
    });
  }

  /** @returns {PartsPanel} */
  makePartsPanel_() {
    return new PartsPanel({
      onBegin: (printEvery) => this.guard_(() => this.batchCarving_.begin(printEvery)),
      onPause: () => this.batchCarving_.pause(),
      onResume: () => this.batchCarving_.resume(),
      onStop: () => this.batchCarving_.stop(),
      onRetry: () => this.batchCarving_.retry(),
      onDownload: () => this.guard_(() => this.batchCarving_.download()),
      onDiscard: () => this.batchCarving_.discard(),
      nameOf: (index) => this.batchCarving_.nameOf(index),
    });
  }

  /** @param {import('./ui/notices.js').Notices} notices @returns {BatchCarving} */
  makeBatchCarving_(notices) {
    return new BatchCarving({
      client: this.client_,
      store: new BatchStore(new Folder('batch')),
      batching: this.batching_,
      carving: this.carving_,
      placing: this.placing_,
      model: this.model_,
      centre: this.centre_,
      panel: this.partsPanel_,
      notices,
      messages: this.messages_,
      currentWork: () => this.session_.currentWork(),
      onContinue: (work) => this.session_.continueWith(work),
      onLock: (locked) => this.batchPanel_.lock(locked),
      guard: (action) => this.guard_(action),
    });
  }

  makeModel_() {
    const panel = new ModelPanel({
      onSample: (id) => this.guard_(() => this.model_.openSample(id)),
      onFile: (file) => this.guard_(() => this.session_.openFile(file)),
      onScale: (scaleToMm) => this.guard_(() => this.model_.rescale(scaleToMm)),
      onUpAxis: (upAxis) => this.guard_(() => this.session_.turnUp(upAxis)),
    });
    return new ModelSession({
      client: this.client_,
      jobs: this.jobs_,
      messages: this.messages_,
      panel,
      centre: this.centre_,
      onReplacing: () => this.carving_.abort(),
      onLoaded: () => this.session_.useModel(),
      onFailed: () => this.session_.allowWork(true),
    });
  }

  makePlacing_() {
    return new Placing({
      client: this.client_,
      model: this.model_,
      centre: this.centre_,
      messages: this.messages_,
      panel: this.placePanel_,
      settings: () => this.session_.plannedSettings(),
      mayMove: () => !this.jobs_.busy,
      onMoved: () => this.guard_(() => this.session_.leaveCarved()),
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
    return new SpotsPanel(
      {
        onSuggest: () =>
          this.guard_(async () => {
            await this.code_.settle(); // apply the text first, or its change would end the search
            await this.spots_.suggest();
          }),
        onSpot: (index) => this.guard_(() => this.spots_.choose(index)),
        onSizes: (shown) => this.guard_(() => this.session_.showSizes(shown)),
      },
      this.legend_,
    );
  }

  makeSpotFinding_() {
    return new SpotFinding({
      client: this.client_,
      jobs: this.jobs_,
      model: this.model_,
      placing: this.placing_,
      messages: this.messages_,
      panel: this.spotsPanel_,
      settings: () => this.session_.settings(),
      onSizes: () => this.guard_(() => this.carving_.show(false)),
    });
  }

  makeCarving_() {
    const panel = new ResultPanel({
      onDownload: (format) => this.guard_(() => this.carving_.download(format)),
      onSaveReport: () => this.guard_(() => this.carving_.saveReport()),
      onPrint: (wanted) => this.carving_.print(wanted),
      onTryPrints: () => this.guard_(() => this.carving_.tryPrints()),
      onRemedy: (remedy, label) => this.guard_(() => this.session_.remedy(remedy, label)),
      onTryViews: async (...options) => {
        /** @type {import('./engine/types.js').ViewTrials | undefined} */ let trials;
        await this.guard_(async () => {
          trials = await this.carving_.tryViews(...options);
        });
        return trials;
      },
    });
    return new Carving({
      client: this.client_,
      jobs: this.jobs_,
      model: this.model_,
      placing: this.placing_,
      messages: this.messages_,
      panel,
      printing: new Printing({ client: this.client_ }),
      work: () => this.session_.work(),
      settings: () => this.session_.settings(),
      valuesAfter: (change) => this.form_.valuesAfter(change),
      fixed: () => Object.keys(kSettings).filter((setting) => this.batching_.decides(setting)),
      write: (values) => this.session_.write({ text: this.code_.text, values }),
      onStart: () => this.spotsPanel_.setSizesShown(false),
      onDone: () => this.undo_.record(),
      onShown: (exists, shown) => this.session_.noteCarved(exists, shown),
      onPrinted: () => {
        this.session_.notePrinted();
        this.preparing_.plan(); // planning had to wait for the print
      },
      guard: (action) => this.guard_(action),
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
      client: this.client_,
      model: this.model_,
      centre: this.centre_,
      placing: this.placing_,
      messages: this.messages_,
      settings: () => this.session_.settings(),
      settingsToSave: () => this.form_.settings(this.code_.text),
      settingKeys: () => this.form_.keys,
      onSettings: (settings) => this.session_.write({ text: settings.text, values: this.form_.valuesFor(settings) }),
      onChanged: () => this.session_.changeSettings(),
      untilIdle: () => this.session_.becomeIdle(),
    });
  }

  /** @param {import('./ui/notices.js').Notices} notices */
  makeContinuing_(notices) {
    return new Continuing({
      last: new LastWork(new Database(), holdsSecret),
      notices,
      current: () => this.session_.currentWork(),
      onContinue: (work) => this.guard_(() => this.session_.continueWith(work)),
    });
  }

  makeUndo_() {
    return new Undo({
      client: this.client_,
      jobs: this.jobs_,
      model: this.model_,
      placing: this.placing_,
      spots: this.spots_,
      carving: this.carving_,
      messages: this.messages_,
      work: () => this.session_.work(),
      write: (state) => this.session_.write(state),
      guard: (action) => this.guard_(action),
      onRestored: () => this.kept_.note(),
    });
  }

  /** Loads the decoder and the message words that the result will need. */
  prepareTelling_() {
    prepareReader();
    void messageWords.come();
  }

  /** @param {URLSearchParams} address */
  start(address) {
    return this.session_.start(address);
  }

  /** @param {() => Promise<unknown>} action */
  guard_(action) {
    return this.recovery_.guard(action);
  }
}
