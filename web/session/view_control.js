// SPDX-License-Identifier: GPL-3.0-or-later
// Connects the view with the work: shows the carved model, and passes on the user's input in the view.

const kVectorDigits = 5;

/**
 * @typedef {object} ViewControlOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('../view/view.js').View} view
 * @property {import('../view/view_tools.js').ViewTools} tools
 * @property {import('../view/live_view.js').LiveView} live
 * @property {import('../ui/view_toolbar.js').ViewToolbar} toolbar
 * @property {import('../ui/face_picker.js').FacePicker} picker
 * @property {import('../view/legend.js').Legend} legend
 * @property {import('../view/inspector_view.js').InspectorView} inspector
 * @property {import('./inspector_control.js').InspectorControl} inspectorControl
 * @property {import('../ui/spots_panel.js').SpotsPanel} spotsPanel
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./placing.js').Placing} placing
 * @property {import('./carving.js').Carving} carving
 * @property {import('./work_editor.js').WorkEditor} editor
 * @property {(action: () => Promise<unknown>) => Promise<void>} guard
 */

export class ViewControl {
  /** @param {ViewControlOptions} options */
  constructor({ client, toolbar, tools, legend, spotsPanel, carving, guard, ...options }) {
    /** @type {import('../view/construction_view.js').ConstructionView | undefined} */ this.construction_ = undefined;
    this.client_ = client;
    this.toolbar_ = toolbar;
    this.tools_ = tools;
    this.legend_ = legend;
    this.spotsPanel_ = spotsPanel;
    this.carving_ = carving;
    this.guard_ = guard;
    this.listen_(options);
    this.listenToToolbar_(options);
    carving.changed.on((exists, isShown) => this.noteCarved_(exists, isShown));
    carving.printed.on(() => this.notePrinted_());
  }

  /** @param {Pick<ViewControlOptions, 'view' | 'picker' | 'inspector' | 'inspectorControl' | 'model' | 'placing' | 'editor'>} options */
  listen_({ view, picker, inspector, inspectorControl, model, placing, editor }) {
    const { client_: client, tools_: tools, toolbar_: toolbar, guard_: guard } = this;
    const act = (/** @type {import('../engine/types.js').ViewAction} */ action) => guard(() => client.act(action));
    const place = (/** @type {number} */ x, /** @type {number} */ y, exact = false) =>
      guard(() => placing.move(() => client.setCentre({ at: [x, y], exact })));
    const lay = async (/** @type {number} */ x, /** @type {number} */ y) => {
      const { hit, buildUp } = await client.layFace([x, y]);
      picker.handlePick(hit);
      if (hit) await editor.editSettings({ buildUp: rounded(buildUp) });
    };
    view.listen({
      onAct: (action) => tools.act(action),
      onPick: (x, y, exact) => (picker.isPicking ? guard(() => lay(x, y)) : place(x, y, exact)),
      onHover: (x, y) => tools.hover(x, y),
      onHoverEnd: () => tools.endHover(),
      onTurn: (notches, x, y) => tools.turn(notches, x, y),
      onBefore: (held) => toolbar.hold(held),
      onResize: (size) =>
        guard(async () => {
          await client.resize(size);
          await inspectorControl.makeRoom();
        }),
    });
    tools.listen({
      onPlace: place,
      onPrint: (picture) => guard(() => client.showPrint(picture?.pixels ?? new Uint8Array(), picture?.width ?? 0)),
      onAdjust: (change) => guard(() => editor.adjust(change)),
      onLight: (light) => guard(() => editor.editSettings({ light })),
      onCancel: () => guard(() => placing.place()),
      onAct: act,
    });
    tools.onLamps = (exist) => toolbar.setLamps(exist);
    picker.listen({ onPick: (picking) => tools.set({ picking }) });
    inspector.listen({ onAct: act, onEngrave: (overrides) => guard(() => this.carving_.engrave(overrides)) });
    placing.placed.on((placement) => {
      toolbar.setPlaced(
        placement !== undefined,
        placement?.capitalMm === null,
        model.engravable && placing.asksForSpot,
      );
      tools.set({ placed: placement !== undefined });
      if (toolbar.constructionShown) void guard(() => this.explain_());
    });
  }

  /** @param {Pick<ViewControlOptions, 'inspectorControl' | 'placing' | 'live'>} options */
  listenToToolbar_({ inspectorControl, placing, live }) {
    const { client_: client, tools_: tools, guard_: guard } = this;
    this.toolbar_.listen({
      onCarved: (carved) => guard(() => this.showCarved_(carved)),
      onBefore: (before) => guard(() => client.show({ carved: !before })),
      onReaderView: () => tools.act({ kind: 'readerView' }),
      onFit: () => tools.act({ kind: 'fit' }),
      onStandard: (name) => tools.act({ kind: 'standard', name }),
      onSection: (isShown, offset) => guard(() => client.show({ section: isShown ? offset : null })),
      onFaceSection: () => tools.act({ kind: 'faceSection' }),
      onDepths: (areShown) => guard(() => this.showDepths_(areShown)),
      onLive: () => {
        live.reset();
        return guard(() => placing.place(true));
      },
      onPlate: (isShown) => guard(() => client.show({ buildPlate: isShown })),
      onLampLight: (isShown) => guard(() => client.show({ lampLight: isShown })),
      onConstruction: (isShown) => guard(() => this.showConstruction_(isShown)),
      onInspector: (isShown) => guard(() => inspectorControl.show(isShown)),
    });
  }

  /** @param {boolean} carved */
  async showCarved_(carved) {
    if (carved) this.spotsPanel_.setSizesShown(false);
    await this.carving_.show(carved);
  }

  /** Reacts to a change of the carved model. @param {boolean} exists @param {boolean} isShown */
  noteCarved_(exists, isShown) {
    this.toolbar_.setCarved(exists, isShown, this.carving_.carved?.report.mark === 'shadow');
    this.tools_.reader.show(isShown ? this.carving_.carved?.report.verification.text : undefined);
    this.tools_.set({ carved: isShown });
    this.notePrinted_();
    if (!isShown || !this.toolbar_.depthsShown) this.legend_.hide('depths');
    else void this.guard_(() => this.showDepths_(true));
  }

  /** Updates the print in the view after a new carving or print. */
  notePrinted_() {
    const { report, printed } = this.carving_.carved ?? {};
    this.tools_.reader.showPrint(
      report?.symbol && printed?.state === 'made'
        ? {
            print: printed.print,
            modules: report.symbol.modules,
            reads: report.verification.verdict.prints.level !== 'bad',
          }
        : undefined,
    );
  }

  /** Shows or hides how the code was placed. @param {boolean} isShown */
  async showConstruction_(isShown) {
    await this.client_.show({ construction: isShown });
    await this.explain_();
    if (isShown) this.tools_.act({ kind: 'faceConstruction' });
  }

  /** Writes the legend of the construction, if it is shown. */
  async explain_() {
    const { ConstructionView } = await import('../view/construction_view.js');
    const construction = this.toolbar_.constructionShown ? await this.client_.construction() : null;
    this.construction_ ??= new ConstructionView();
    this.tools_.onConstruction = (points) => this.construction_?.mark(points);
    this.construction_.explain(construction);
  }

  /** Shows or hides the depths as colours on the carved model. @param {boolean} areShown */
  async showDepths_(areShown) {
    const { topMm, deepestMm } = await this.client_.show({ depths: areShown });
    if (areShown) this.legend_.show('depths', topMm, deepestMm > topMm);
    else this.legend_.hide('depths');
    if (areShown && !this.carving_.shown) await this.showCarved_(true);
  }
}

/** @param {import('../engine/types.js').LaidFace['buildUp']} buildUp @returns {import('../engine/types.js').Settings['buildUp']} */
const rounded = (buildUp) =>
  Array.isArray(buildUp) ? /** @type {any} */ (buildUp.map((part) => Number(part.toFixed(kVectorDigits)))) : buildUp;
