// SPDX-License-Identifier: GPL-3.0-or-later
// The page's side of the inspector, which the engine draws on the canvas: the area where it may open, the keys that it
// takes, and its state in words for those who cannot see it.
import { freeArea, obstaclesOver } from './free_area.js';
import { InspectorFigures } from './inspector_figures.js';

/** @typedef {import('../engine/types.js').InspectorState} InspectorState */
/** @typedef {import('../engine/types.js').ViewAction} ViewAction */

/**
 * @typedef {object} InspectorListener
 * @property {(action: ViewAction) => void} onAct
 * @property {(overrides: string) => void} onEngrave  the inspector's Engrave button was pressed; the changes it makes, in
 *   words
 */

export class InspectorView {
  /**
   * @param {HTMLElement} stage
   * @param {HTMLElement} view  holds the canvas
   */
  constructor(stage, view) {
    this.stage_ = stage;
    this.view_ = view;
    /** @type {InspectorListener | undefined} */ this.listener_ = undefined;
    this.figures_ = new InspectorFigures();
    this.takesKeys_ = false;
    this.engraveAsked_ = 0;
    // Capture the keys before the view and the page, both of which have shortcuts.
    view.addEventListener('keydown', (event) => this.key_(event), { capture: true });
  }

  /** @param {InspectorListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /** Returns the part of the view that no element of the page covers. */
  area() {
    const { width, height } = this.view_.getBoundingClientRect();
    return freeArea({ width, height }, obstaclesOver(this.stage_, this.view_));
  }

  /** @param {InspectorState | undefined} state  undefined: the inspector was closed, or its engine is gone */
  update(state) {
    this.takesKeys_ = state?.keyboard ?? false;
    this.figures_.show(state?.figures);
    this.view_.style.setProperty('--beside-inspector', state ? beside(state.window) : 'none');
    const canvas = this.view_.querySelector('canvas');
    if (canvas) canvas.style.cursor = state?.cursor ?? '';
    if (!state) {
      this.engraveAsked_ = 0;
      delete this.view_.dataset.inspector;
      return;
    }
    this.view_.dataset.inspector = JSON.stringify(state);
    const isAsked = state.engraveAsked > this.engraveAsked_;
    this.engraveAsked_ = state.engraveAsked;
    if (isAsked) this.listener_?.onEngrave(state.overrides);
  }

  /** @param {KeyboardEvent} event */
  key_(event) {
    if (!this.takesKeys_ || event.isComposing) return;
    const { key, ctrlKey, metaKey, shiftKey } = event;
    this.listener_?.onAct({ kind: 'key', key, control: ctrlKey || metaKey, shift: shiftKey });
    event.preventDefault();
    event.stopPropagation();
  }
}

/** Returns a clip path of everything but a window. @param {InspectorState['window']} window */
const beside = ([x, y, width, height]) =>
  `path(evenodd, 'M-9999-9999H9999V9999H-9999Z M${x} ${y}h${width}v${height}h${-width}Z')`;
