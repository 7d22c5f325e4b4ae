// SPDX-License-Identifier: GPL-3.0-or-later
// Moves, turns and sizes the placed code with its handles, the keyboard, two fingers, or Shift and the wheel. During
// the gesture the engine shows every change at once; at its end the listener gets the new place or settings.
import { isReplaced } from '../engine/client.js';
import { CodeHandles } from './code_handles.js';
import {
  roundedSize,
  scaleBetween,
  snappedRotation,
  squareMaps,
  turnBetween,
  twistBetween,
} from './handle_geometry.js';
import { NewestOnly } from './newest_only.js';

/** @typedef {import('../engine/client.js').EngineClient} EngineClient */
/** @typedef {import('../engine/types.js').CodeFacts} CodeFacts */
/** @typedef {import('../engine/types.js').CodeOnScreen} CodeOnScreen */
/** @typedef {import('./code_chip.js').CodeChip} CodeChip */
/** @typedef {import('./handle_geometry.js').HandleKind} HandleKind */
/** @typedef {import('./handle_geometry.js').Point} Point */

const kLeastMm = 5; // same limits as the fields of these settings
const kMostMm = 1000;
const kClickSlopPx = 4;
const kKeyStepPx = 6;
const kWheelStepDeg = 5;
const kCommitMs = 450; // pause after the last key or wheel step

/**
 * @typedef {object} EditListener
 * @property {(x: number, y: number) => void} onPlace  move the code there, CSS pixels of the canvas
 * @property {(change: { rotateDeg?: number, symbolMm?: number }) => void} onAdjust
 * @property {() => void} onCancel  discard the preview
 */

/**
 * A handle that is held, and the code at the start of the gesture.
 * @typedef {object} Drag
 * @property {HandleKind | 'twist'} kind
 * @property {number} pointerId
 * @property {Point} from            on the screen
 * @property {Point} at
 * @property {CodeOnScreen} code
 * @property {boolean} moved
 * @property {{ pointerId: number, from: Point, at: Point }} [second]  second finger
 */

export class CodeEditor {
  /**
   * @param {object} options
   * @param {EngineClient} options.client
   * @param {HTMLElement} options.overlay  covers the canvas
   * @param {CodeChip} options.chip
   * @param {EditListener} options.listener
   */
  constructor({ client, overlay, chip, listener }) {
    this.client_ = client;
    this.overlay_ = overlay;
    this.chip_ = chip;
    this.listener_ = listener;
    this.handles_ = new CodeHandles(overlay);
    this.isEnabled_ = false;
    /** @type {CodeOnScreen | null} */ this.code_ = null;
    /** @type {Drag | undefined} */ this.drag_ = undefined;
    /** @type {{ rotateDeg?: number, symbolMm?: number, at?: Point }} */ this.pending_ = {};
    /** @type {{ rotateDeg?: number, symbolMm?: number }} */ this.committed_ = {}; // but not yet shown by the engine
    /** @type {ReturnType<typeof setTimeout> | undefined} */ this.commit_ = undefined;
    this.queue_ = new NewestOnly((/** @type {() => Promise<void>} */ task) => task());
    for (const kind of /** @type {HandleKind[]} */ (['move', 'turn', 'size'])) {
      const element = this.handles_.handles[kind];
      element.addEventListener('pointerdown', (event) => this.hold_(kind, event));
      element.addEventListener('keydown', (event) => this.key_(kind, event));
      element.addEventListener('blur', () => void this.commitNow_());
    }
    this.handles_.upright.addEventListener('click', () => listener.onAdjust({ rotateDeg: 0 }));
    this.follow_ = (/** @type {PointerEvent} */ event) => this.dragged_(event);
    this.join_ = (/** @type {PointerEvent} */ event) => this.secondFinger_(event);
    this.escape_ = (/** @type {KeyboardEvent} */ event) => {
      if (event.key === 'Escape') this.cancel_(event);
    };
  }

  /** @param {boolean} isEnabled  a code may be placed and no job runs */
  setEnabled(isEnabled) {
    this.isEnabled_ = isEnabled;
    this.handles_.show(isEnabled ? this.code_ : null);
  }

  /** @param {CodeOnScreen | null} code  as shown now */
  update(code) {
    const { code_: before } = this;
    if (code?.rotationDeg !== before?.rotationDeg || code?.symbolMm !== before?.symbolMm) this.committed_ = {};
    this.code_ = code;
    if (this.isEnabled_) this.handles_.show(code);
  }

  /**
   * Turns the code by notches of the wheel while Shift is held.
   * @param {number} notches
   * @param {number} x
   * @param {number} y
   */
  turn(notches, x, y) {
    const { code_: code } = this;
    if (!code || !this.isEnabled_) return;
    const { rotateDeg, symbolMm } = this.soFar_(code);
    this.pending_.rotateDeg = wrapped(rotateDeg + notches * kWheelStepDeg);
    this.adjust_(this.pending_.rotateDeg, symbolMm, [x, y]);
    this.commitSoon_();
  }

  /** @param {HandleKind} kind @param {PointerEvent} event */
  hold_(kind, event) {
    const { code_: code } = this;
    if (event.button !== 0 || !code || this.drag_) return;
    event.preventDefault();
    this.handles_.handles[kind].focus({ preventScroll: true });
    const at = this.positionOf_(event);
    this.drag_ = { kind, pointerId: event.pointerId, from: at, at, code, moved: false };
    this.handles_.hold(kind);
    for (const type of /** @type {const} */ (['pointermove', 'pointerup', 'pointercancel'])) {
      addEventListener(type, this.follow_, { capture: true });
    }
    addEventListener('pointerdown', this.join_, { capture: true });
    addEventListener('keydown', this.escape_, { capture: true });
  }

  /** Lets a second finger on the held grip turn and size the code. @param {PointerEvent} event */
  secondFinger_(event) {
    const { drag_: drag } = this;
    if (!drag) return;
    event.stopPropagation();
    if (drag.kind !== 'move' || event.pointerType !== 'touch' || !this.code_) return;
    event.preventDefault();
    const at = this.positionOf_(event);
    drag.kind = 'twist';
    drag.code = this.code_;
    drag.from = drag.at;
    drag.second = { pointerId: event.pointerId, from: at, at };
  }

  /** @param {PointerEvent} event */
  dragged_(event) {
    const { drag_: drag } = this;
    if (!drag) return;
    event.stopPropagation();
    const isFirst = event.pointerId === drag.pointerId;
    if (!isFirst && event.pointerId !== drag.second?.pointerId) return;
    if (event.type === 'pointercancel') {
      this.cancel_();
    } else if (event.type === 'pointerup') {
      void this.finish_(drag);
    } else {
      const at = this.positionOf_(event);
      if (isFirst) drag.at = at;
      else if (drag.second) drag.second.at = at;
      if (drag.kind === 'move' && !drag.moved && distance(drag.at, drag.from) <= kClickSlopPx) return;
      if (drag.kind !== 'twist') drag.moved = true;
      this.showDrag_(drag);
    }
  }

  /** @param {Drag} drag */
  showDrag_(drag) {
    if (drag.kind === 'move') {
      this.move_(this.target_(drag));
      return;
    }
    this.pending_ = this.adjustmentOf_(drag);
    const { rotateDeg = drag.code.rotationDeg, symbolMm = drag.code.symbolMm } = this.pending_;
    this.adjust_(rotateDeg, symbolMm, drag.at);
  }

  /** Returns where the middle of the code goes when its grip is dragged. @param {Drag} drag @returns {Point} */
  target_({ at, from, code }) {
    const [x, y] = squareMaps(code.corners).toScreen([0, 0]);
    return [x + at[0] - from[0], y + at[1] - from[1]];
  }

  /** @param {Drag} drag @returns {{ rotateDeg?: number, symbolMm?: number }} */
  adjustmentOf_({ kind, code, from, at, second }) {
    if (kind === 'twist' && second) {
      const { turnDeg, factor } = twistBetween([from, second.from], [at, second.at]);
      return {
        rotateDeg: snappedRotation(code.rotationDeg + turnDeg),
        symbolMm: roundedSize(code.symbolMm * factor, kLeastMm, kMostMm),
      };
    }
    const { toSquare } = squareMaps(code.corners);
    const [before, now] = [toSquare(from), toSquare(at)];
    return kind === 'turn'
      ? { rotateDeg: snappedRotation(code.rotationDeg + turnBetween(before, now)) }
      : { symbolMm: roundedSize(code.symbolMm * scaleBetween(before, now), kLeastMm, kMostMm) };
  }

  /** @param {Drag} drag */
  async finish_(drag) {
    const { pending_ } = this;
    this.release_();
    const change = await this.fitting_(pending_, drag.code);
    if (drag.kind === 'move' || (drag.kind === 'twist' && drag.moved)) {
      this.listener_.onPlace(...(drag.moved ? this.target_(drag) : drag.at));
    }
    if (drag.kind !== 'move' && (change.rotateDeg !== undefined || change.symbolMm !== undefined)) {
      this.listener_.onAdjust(change);
    }
  }

  /** @param {Event} [event] */
  cancel_(event) {
    event?.stopPropagation();
    this.release_();
    this.listener_.onCancel();
  }

  /**
   * Returns the change with no larger size than fits, as the engine tells: it may not have shown the last one yet.
   * @param {typeof this.pending_} change
   * @param {CodeOnScreen} code
   */
  async fitting_(change, code) {
    const { rotateDeg = code.rotationDeg, symbolMm } = change;
    if (symbolMm === undefined) return change;
    try {
      const { code: fitting } = await this.client_.adjustCode({ rotateDeg, symbolMm });
      const isTooLarge = fitting !== undefined && fitting.symbolMm < symbolMm;
      return isTooLarge ? { ...change, symbolMm: Math.floor(fitting.symbolMm * 10) / 10 } : change;
    } catch {
      return change; // placing it reports why it does not fit
    }
  }

  release_() {
    this.drag_ = undefined;
    this.pending_ = {};
    clearTimeout(this.commit_);
    this.commit_ = undefined;
    this.queue_.forget();
    this.handles_.hold(undefined);
    this.chip_.hide();
    for (const type of /** @type {const} */ (['pointermove', 'pointerup', 'pointercancel'])) {
      removeEventListener(type, this.follow_, { capture: true });
    }
    removeEventListener('pointerdown', this.join_, { capture: true });
    removeEventListener('keydown', this.escape_, { capture: true });
  }

  /** @param {HandleKind} kind @param {KeyboardEvent} event */
  key_(kind, event) {
    const { code_: code } = this;
    if (!code || event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    const middle = squareMaps(code.corners).toScreen([0, 0]);
    if (event.key === 'Escape' && this.commit_ !== undefined) {
      this.cancel_();
    } else if (event.key === 'Enter') {
      void this.commitNow_();
    } else if (kind === 'move' && arrow) {
      const step = kKeyStepPx * (event.shiftKey ? 5 : 1);
      const [x, y] = this.pending_.at ?? middle;
      this.pending_.at = [x + arrow[0] * step, y + arrow[1] * step];
      this.move_(this.pending_.at);
      this.commitSoon_();
    } else if (kind !== 'move' && stepOf(event) !== undefined) {
      this.step_(kind, /** @type {number} */ (stepOf(event)), code, middle);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  }

  /**
   * @param {'turn' | 'size'} kind
   * @param {number} steps  NaN: upright
   * @param {CodeOnScreen} code
   * @param {Point} beside
   */
  step_(kind, steps, code, beside) {
    const { rotateDeg, symbolMm } = this.soFar_(code);
    if (kind === 'turn') this.pending_.rotateDeg = Number.isNaN(steps) ? 0 : wrapped(rotateDeg + steps);
    else if (!Number.isNaN(steps)) this.pending_.symbolMm = roundedSize(symbolMm + steps * 0.5, kLeastMm, kMostMm);
    this.adjust_(this.pending_.rotateDeg ?? rotateDeg, this.pending_.symbolMm ?? symbolMm, beside);
    this.commitSoon_();
  }

  /** Returns the rotation and size that the next step starts from. @param {CodeOnScreen} code */
  soFar_({ rotationDeg, symbolMm }) {
    return { rotateDeg: Math.round(rotationDeg), symbolMm, ...this.committed_, ...this.pending_ };
  }

  commitSoon_() {
    clearTimeout(this.commit_);
    this.commit_ = setTimeout(() => void this.commitNow_(), kCommitMs);
  }

  async commitNow_() {
    const { code_: code, pending_ } = this;
    if (this.commit_ === undefined || this.drag_ || !code) return;
    this.release_();
    const { at: _, ...asked } = pending_;
    this.committed_ = asked;
    const { at, ...change } = await this.fitting_(pending_, code);
    if (at) this.listener_.onPlace(...at);
    if (this.committed_ === asked) this.committed_ = change;
    if (change.rotateDeg !== undefined || change.symbolMm !== undefined) this.listener_.onAdjust(change);
  }

  /** @param {Point} at */
  move_([x, y]) {
    this.ask_(async () => (await this.client_.adjustCode({ at: [x, y] })).code, [x, y]);
  }

  /** @param {number} rotateDeg @param {number} symbolMm @param {Point} beside */
  adjust_(rotateDeg, symbolMm, beside) {
    this.handles_.setValues(rotateDeg, symbolMm);
    this.ask_(async () => (await this.client_.adjustCode({ rotateDeg, symbolMm })).code, beside);
  }

  /** @param {() => Promise<CodeFacts | undefined>} show @param {Point} beside */
  ask_(show, [x, y]) {
    this.queue_.ask(async () => {
      try {
        const facts = await show();
        if (facts && (this.drag_ || this.commit_ !== undefined)) this.chip_.show(facts, x, y);
      } catch (thrown) {
        if (!isReplaced(thrown)) this.chip_.hide();
      }
    });
  }

  /** @param {PointerEvent} event @returns {Point} */
  positionOf_(event) {
    const { left, top } = this.overlay_.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }
}

/** @param {Point} a @param {Point} b */
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** @param {number} deg */
const wrapped = (deg) => deg - 360 * Math.round(deg / 360) + 0;

/**
 * Returns the step that a key adds to a slider's value; NaN resets the value.
 * @param {KeyboardEvent} event
 * @returns {number | undefined}
 */
function stepOf(event) {
  return { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -15, PageUp: 15, Home: NaN }[event.key];
}
