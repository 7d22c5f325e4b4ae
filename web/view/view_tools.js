// SPDX-License-Identifier: GPL-3.0-or-later
// The overlays of the 3D view: the code that follows the pointer, the handles of the placed code, the cube, and the
// phone view with its caption.
import { make } from '../dom/dom.js';
import { CodeChip } from './code_chip.js';
import { CodeEditor } from './code_editor.js';
import { HeightMark } from './height_mark.js';
import { HoverPreview } from './hover_preview.js';
import { LampMarks } from './lamp_marks.js';
import { ReaderView } from './reader_view.js';
import { SearchPicture } from './search_picture.js';
import { ViewCube } from './view_cube.js';

/** @typedef {import('../engine/client.js').EngineClient} EngineClient */
/** @typedef {import('../engine/types.js').ViewAction} ViewAction */

/**
 * @typedef {object} ViewToolsOptions
 * @property {EngineClient} client
 * @property {HTMLElement} stage     holds the canvas
 * @property {HTMLElement} overlays  holds the overlays outside the canvas
 * @property {import('./live_view.js').LiveView} live
 */

/**
 * @typedef {import('./code_editor.js').EditListener & import('./lamp_marks.js').LampListener &
 *   { onAct: (action: ViewAction) => void,
 *   onPrint: (picture: import('../engine/types.js').GreyImage | undefined) => void }} ToolsListener
 *   `onPrint`: shows the picture of a print on the surface, or hides it
 */

const kClearFacing = 0.7; // cosine of the angle from which the modules of a code are seen well
const kClearShare = 0.22; // edge of such a code, as a part of the view's shorter side

export class ViewTools {
  /** @param {ViewToolsOptions} options */
  constructor({ client, stage, overlays, live }) {
    /** @type {ToolsListener | undefined} */ this.listener_ = undefined;
    const surface = make('div', { className: 'code-overlay' });
    stage.append(surface);
    const chip = new CodeChip(surface);
    this.hover_ = new HoverPreview(client, chip, live);
    this.editor_ = new CodeEditor({ client, overlay: surface, chip, listener: this.passOn_() });
    this.height_ = new HeightMark(surface); // below the suns of the lamps
    this.lamps_ = new LampMarks({ client, overlay: surface, listener: this.passOn_() });
    this.stage_ = stage;
    this.search = new SearchPicture();
    this.cube_ = new ViewCube(overlays, (name) => this.act({ kind: 'standard', name }));
    this.reader = new ReaderView(overlays, surface, (picture) => this.listener_?.onPrint(picture));
    /** Announces that the user moves the camera. @type {(() => void) | undefined} */ this.onMoved = undefined;
    /** Shows the names of a construction's points. @type {((points: import('../engine/types.js').ConstructionOnScreen | null) => void) | undefined} */
    this.onConstruction = undefined;
    /** Tells whether there are lamps round the placed code. @type {((exist: boolean) => void) | undefined} */
    this.onLamps = undefined;
    /** @type {import('../engine/types.js').CodeOnScreen | null} */ this.code_ = null;
    this.engravable_ = false;
    this.busy_ = false;
    this.carved_ = false;
    this.placed_ = false;
    this.picking_ = false;
  }

  /** @param {ToolsListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /** @returns {import('./code_editor.js').EditListener & import('./lamp_marks.js').LampListener} */
  passOn_() {
    return {
      onPlace: (x, y) => this.listener_?.onPlace(x, y),
      onAdjust: (change) => this.listener_?.onAdjust(change),
      onLight: (light) => this.listener_?.onLight(light),
      onCancel: () => this.listener_?.onCancel(),
    };
  }

  /** Passes on every camera action. @param {ViewAction} action */
  act(action) {
    if (action.kind === 'readerView' && !this.placed_) return;
    if (action.kind === 'readerView') this.reader.enter();
    else if (action.kind !== 'pointer') this.reader.leave();
    this.enable_();
    if (action.kind !== 'pointer' && action.kind !== 'key') this.onMoved?.();
    this.listener_?.onAct(action);
  }

  /** @param {import('../engine/types.js').ViewState} state */
  update({ code, lamps, buildPlate, construction, axes }) {
    this.code_ = code;
    this.height_.show(buildPlate);
    this.editor_.update(code);
    this.lamps_.show(lamps);
    if (code) this.onLamps?.(lamps.length > 0);
    this.onConstruction?.(construction);
    this.reader.update(code);
    this.cube_.turn(axes);
  }

  /** True if the modules of the code are seen well from the camera. */
  get seesCode() {
    const { code_: code, stage_: stage } = this;
    if (!code) return false;
    const [[x, y], [toX, toY]] = code.corners;
    const share = Math.hypot(toX - x, toY - y) / Math.max(1, Math.min(stage.clientWidth, stage.clientHeight));
    return code.facing > kClearFacing && share > kClearShare;
  }

  /**
   * @param {{ engravable?: boolean, busy?: boolean, carved?: boolean, placed?: boolean, picking?: boolean }} state
   *   whether the model can take a code, a job runs, the carved model is shown, a code is placed, and the next click
   *   picks a face
   */
  set({
    engravable = this.engravable_,
    busy = this.busy_,
    carved = this.carved_,
    placed = this.placed_,
    picking = this.picking_,
  }) {
    this.picking_ = picking;
    this.engravable_ = engravable;
    if (!busy) this.search.hide();
    this.busy_ = busy;
    this.carved_ = carved;
    this.placed_ = placed;
    if (!placed) this.reader.leave(); // a phone sees no code
    this.enable_();
  }

  enable_() {
    const mayChange = this.engravable_ && !this.busy_ && !this.picking_;
    this.hover_.setEnabled(mayChange && !this.carved_);
    this.editor_.setEnabled(mayChange && !this.carved_ && !this.reader.shown);
    this.lamps_.setEnabled(mayChange);
  }

  /** @param {number} x @param {number} y */
  hover(x, y) {
    this.hover_.move(x, y);
  }

  endHover() {
    this.hover_.end();
  }

  /** @param {number} notches @param {number} x @param {number} y */
  turn(notches, x, y) {
    this.hover_.end();
    this.editor_.turn(notches, x, y);
  }
}
