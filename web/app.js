// SPDX-License-Identifier: GPL-3.0-or-later
// Creates the panels, the view, the engine, the store of the work and the parts of the session. Each part connects itself
// with its panel and with the parts before it; this file connects it with later ones.
import { EngineClient } from './engine/client.js';
import { holdsSecret } from './payloads/secrets.js';
import { Autosave } from './session/autosave.js';
import { Database } from './storage/database.js';
import { Folder } from './storage/folder.js';
import { LastWork } from './storage/last_work.js';
import { prepareReader } from './decoder/reader.js';
import { BatchStore } from './batch/batch_store.js';
import { BatchCarving } from './session/batch_carving.js';
import { Batching } from './session/batching.js';
import { Carving } from './session/carving.js';
import { WorkEditor } from './session/work_editor.js';
import { Exporter } from './session/exporter.js';
import { faceNewCodes } from './session/face_new_code.js';
import { InspectorControl } from './session/inspector_control.js';
import { Jobs } from './session/jobs.js';
import { ModelSession } from './session/model_session.js';
import { FileOpener } from './session/file_opener.js';
import { Placing } from './session/placing.js';
import { IdlePreparation } from './session/idle_preparation.js';
import { Printing } from './session/printing.js';
import { Recovery } from './session/recovery.js';
import { Session } from './session/session.js';
import { showWork } from './session/show_work.js';
import { SpotSearch } from './session/spot_search.js';
import { Startup } from './session/startup.js';
import { Undo } from './session/undo.js';
import { ViewControl } from './session/view_control.js';
import { WorkStore } from './session/work_store.js';
import { kNoWork } from './session/work.js';
import { text } from './i18n/catalogue.js';
import { messageWords } from './i18n/message_words.js';
import { BatchPanel } from './ui/batch_panel.js';
import { CodePanel } from './ui/code_panel.js';
import { byId } from './dom/dom.js';
import { ExportPanel } from './ui/export_panel.js';
import { FacePicker } from './ui/face_picker.js';
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
import { LiveView } from './view/live_view.js';
import { ViewTools } from './view/view_tools.js';

/** Creates the panels. They know no other part of the page. */
function makePanels() {
  const legend = new Legend();
  const stage = byId('view', HTMLElement);
  return {
    legend,
    messages: new Messages(),
    view: new View(stage),
    inspector: new InspectorView(byId('stage', HTMLElement), stage),
    toolbar: new ViewToolbar(),
    picker: new FacePicker(stage),
    form: new SettingsForm(),
    modelPanel: new ModelPanel(),
    batchPanel: new BatchPanel(),
    placePanel: new PlacePanel(),
    spotsPanel: new SpotsPanel(legend),
    workPanel: new WorkPanel(),
    resultPanel: new ResultPanel(),
    partsPanel: new PartsPanel(),
    exportPanel: new ExportPanel(),
  };
}

/**
 * Creates the engine, and the parts that show it.
 * @param {ReturnType<typeof makePanels>} panels
 * @param {(action: () => Promise<unknown>) => Promise<void>} guard
 * @param {{ onEvent: (event: import('./engine/types.js').HostEvent) => void, onReplaced: () => void }} listener
 */
function makeEngine({ view, inspector, toolbar }, guard, { onEvent, onReplaced }) {
  const client = new EngineClient({
    makeCanvas: () => view.makeCanvas(),
    onEvent: (event) => (event.event === 'inspector' ? inspector.update(event.state) : onEvent(event)),
    onView: (state) => tools.update(state),
    onSearch: (search) => tools.search.show(search),
    onReplaced,
  });
  const overlays = byId('view-overlays', HTMLElement);
  const live = new LiveView(() => toolbar.liveShown);
  const tools = new ViewTools({ client, stage: byId('view', HTMLElement), overlays, live });
  return {
    client,
    tools,
    live,
    inspectorControl: new InspectorControl({ client, view, window: inspector, toolbar, guard }),
  };
}

/**
 * Prepares the next carving in idle moments.
 * @param {{ client: EngineClient, jobs: Jobs, placing: Placing, carving: Carving, live: LiveView }} parts
 * @param {ReturnType<typeof makePanels>} panels
 */
function prepareCarvings({ client, jobs, placing, carving, live }, { placePanel }) {
  const preparation = new IdlePreparation({
    client,
    prepareReader: () => {
      prepareReader();
      void messageWords.load();
    },
    isBusy: () => jobs.busy || carving.isPrinting,
    live,
    onDepths: (depths) => placePanel.showDepths(depths),
    user: window,
    isOverModel: ({ target }) => target instanceof HTMLCanvasElement,
  });
  placing.placed.on((placement) => preparation.setPlaced(placement !== undefined));
  carving.printed.on(() => preparation.plan()); // planning had to wait for the print
}

/** Creates all parts of the page. @param {import('./ui/notices.js').Notices} notices @returns {Startup} */
function connect(notices) {
  const panels = makePanels();
  const { messages, form, batchPanel, placePanel, spotsPanel, workPanel } = panels;
  messages.say(() => text('page.starting'));
  const recovery = new Recovery(messages, () => client.replace());
  const guard = recovery.guard.bind(recovery);
  const theme = new Theme((dark) => guard(() => client.show({ dark })));
  const { client, tools, live, inspectorControl } = makeEngine(panels, guard, {
    onEvent: (event) => guard(() => recovery.recoverFrom(event)),
    onReplaced: () => guard(() => startup.restore()),
  });
  const code = new CodePanel({
    settings: (content) => batching.settings(content),
    symbolOf: (settings) => client.symbol(settings),
    adviceOn: (content) => client.textAdvice(content),
  });
  const { defaults } = form;
  const store = new WorkStore({ ...kNoWork, text: code.initialText, settings: defaults });
  showWork(store, { form, code, place: placePanel, batch: batchPanel });

  const jobs = new Jobs({ panel: workPanel, messages, onBusy: () => session.updateControls() });
  const base = { client, store, defaults, messages, notices, jobs, guard };
  const batching = new Batching({ ...base, panel: batchPanel, isLocked: () => batchCarving.isOpen });
  const model = new ModelSession({
    ...base,
    panel: panels.modelPanel,
    onReplacing: () => carving.abort(),
    onLoaded: () => session.useModel(),
    onFailed: () => session.updateControls(),
  });
  const placing = new Placing({ ...base, model, batching, code, panel: placePanel });
  const carving = new Carving({
    ...base,
    ...{ model, batching, placing },
    panel: panels.resultPanel,
    printing: new Printing({ client }),
    onRemedy: (remedy, label) => editor.remedy(remedy, label),
    onAnother: (source) => editor.goOnWith(source),
  });
  const carved = { ...base, model, batching, placing, carving };
  const spots = new SpotSearch({ ...carved, code, panel: spotsPanel });
  const editor = new WorkEditor({ ...carved, spots, form, code, batchPanel, placePanel });
  const storage = new BatchStore(new Folder('batch'));
  const batchCarving = new BatchCarving({ ...carved, editor, storage, panel: panels.partsPanel });
  const exporter = new Exporter({ ...carved, editor, panel: panels.exportPanel });
  const autosave = new Autosave({ ...base, last: new LastWork(new Database(), holdsSecret), editor });
  const undo = new Undo({ ...carved, spots, editor, autosave });
  new ViewControl({ ...carved, ...panels, tools, live, inspectorControl, editor });
  faceNewCodes({ client, carving, tools, prefersStill: () => matchMedia('(prefers-reduced-motion: reduce)').matches });
  const session = new Session({ ...carved, ...panels, spots, undo, code, tools, live });
  const opener = new FileOpener({ ...carved, editor, exporter, undo, code, tools, panel: panels.modelPanel });
  const { view, toolbar } = panels;
  const parts = { view, toolbar, theme, inspectorControl, batchCarving, exporter, autosave, opener, session };
  const startup = new Startup({ ...carved, ...parts });
  prepareCarvings({ ...carved, live }, panels);
  byId('start-over', HTMLButtonElement).addEventListener('click', () => guard(() => opener.startOver()));
  return startup;
}

export class App {
  /** @param {import('./ui/notices.js').Notices} notices */
  constructor(notices) {
    offerLanguages();
    this.startup_ = connect(notices);
    this.help_ = new HelpSheet();
  }

  /** @param {URLSearchParams} address */
  start(address) {
    return this.startup_.start(address);
  }
}
