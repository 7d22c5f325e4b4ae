// SPDX-License-Identifier: GPL-3.0-or-later
// The inspector over the canvas: its events, its letters and its state for the page.
import { drawGlyphs, lettersOf } from './glyphs.js';

/** @typedef {import('./types.js').InspectorEvent} InspectorEvent */
/** @typedef {Pick<import('./verbs.js').Calls<typeof import('./verbs.js').kInnerVerbs>, 'inspector' | 'inspectorGlyphs'>} InspectorVerbs */

const kFontPx = 14;

export class InspectorLink {
  isShown = false;
  takesPointer = false;
  frames_ = 0; // since it was opened
  stateText_ = '';
  isStill_ = false;
  letters_ = lettersOf([]);
  glyphsPx_ = 0; // size of the letters that were given; 0: none

  /**
   * @param {InspectorVerbs} engine
   * @param {(state: import('./types.js').InspectorState) => void} tell
   */
  constructor(engine, tell) {
    this.engine_ = engine;
    this.tell_ = tell;
  }

  /** Hands over an event, and letters for the canvas's resolution. @param {InspectorEvent} event @param {number} pixelRatio */
  handle(event, pixelRatio) {
    if (event.kind === 'show') {
      this.isShown = event.shown;
      this.frames_ = 0;
      this.takesPointer = false;
      this.stateText_ = '';
      this.isStill_ = false;
    }
    if (event.kind === 'texts') {
      this.letters_ = lettersOf(Object.values(event.texts));
      this.glyphsPx_ = 0;
    }
    this.engine_.inspector(event);
    this.giveGlyphs(pixelRatio);
  }

  /** Hands over a pointer's event. @param {InspectorEvent & { kind: 'pointer' }} event */
  point(event) {
    this.takesPointer = this.engine_.inspector(event);
  }

  /** Gives the page's letters at the canvas's resolution. @param {number} pixelRatio */
  giveGlyphs(pixelRatio) {
    const sizePx = kFontPx * pixelRatio;
    if (!this.isShown || this.glyphsPx_ === sizePx) return;
    const glyphs = drawGlyphs(this.letters_, sizePx);
    if (!glyphs) return;
    this.engine_.inspectorGlyphs(glyphs.lineHeight, glyphs.metrics, glyphs.alpha);
    this.glyphsPx_ = sizePx;
  }

  /**
   * Reports the state after a frame. Dear ImGui takes several frames to lay out a change, so frames follow until two
   * states are equal.
   * @param {import('./verbs.js').InspectorState} state
   * @returns {boolean}  true: draw another frame
   */
  report(state) {
    this.frames_ += 1;
    if (this.frames_ === 1) return false; // the first layout is provisional
    const text = JSON.stringify(state);
    const still = text === this.stateText_;
    if (still && this.isStill_) return false;
    this.stateText_ = text;
    this.isStill_ = still;
    this.tell_({ ...state, still });
    return !still;
  }
}
