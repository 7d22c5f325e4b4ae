// SPDX-License-Identifier: GPL-3.0-or-later
// The element of the 3D view: its canvas, its size, and its pointer and keyboard input.
import { GestureReader } from './gestures.js';

/** @typedef {import('../engine/types.js').ViewAction} ViewAction */
/** @typedef {import('../engine/types.js').ViewSize} ViewSize */

const kKeyOrbitPx = 30;
const kKeyPanPx = 30;
const kKeyZoom = 1.2;
const kMaxPixelRatio = 2; // a finer canvas costs time without visible gain

/** @type {Record<string, import('../engine/types.js').StandardView>} */
export const kStandardViews = { 1: 'front', 2: 'back', 3: 'left', 4: 'right', 5: 'top', 6: 'bottom', 7: 'iso' };

/**
 * @typedef {object} ViewListener
 * @property {(action: ViewAction) => void} onAct
 * @property {(x: number, y: number, exact?: boolean) => void} onPick  `exact`: exactly there, even at an edge
 * @property {(x: number, y: number) => void} [onHover]  the mouse moved with no button held
 * @property {() => void} [onHoverEnd]
 * @property {(held: boolean) => void} [onBefore]  B, which shows the model before carving, is held
 * @property {(notches: number, x: number, y: number) => void} [onTurn]  the wheel, with Shift held
 * @property {(size: ViewSize) => void} onResize
 */

export class View {
  /** @param {HTMLElement} stage  holds the canvas */
  constructor(stage) {
    this.stage_ = stage;
    /** @type {ViewListener | undefined} */ this.listener_ = undefined;
    /** True while the inspector needs the pointer's position. */
    this.reportsPointer = false;
    this.turned_ = 0; // wheel notches left over, less than one
    const gestures = new GestureReader({
      onOrbit: (dx, dy) => this.listener_?.onAct({ kind: 'orbit', dx, dy }),
      onPan: (dx, dy) => this.listener_?.onAct({ kind: 'pan', dx, dy }),
      onZoom: (factor, x, y) => this.listener_?.onAct({ kind: 'zoom', factor, x, y }),
      onClick: (x, y, alt) => this.listener_?.onPick(x, y, alt),
    });
    for (const type of /** @type {const} */ (['pointerdown', 'pointermove', 'pointerup', 'pointercancel'])) {
      stage.addEventListener(type, (event) => {
        if (event.target !== this.canvas_) return;
        if (type === 'pointerdown') this.canvas_.setPointerCapture(event.pointerId);
        this.tellPointer_(event, 0);
        gestures.pointer(type, event);
        if (type === 'pointermove' && event.pointerType === 'mouse' && event.buttons === 0) {
          this.listener_?.onHover?.(event.offsetX, event.offsetY);
        } else {
          this.listener_?.onHoverEnd?.();
        }
      });
    }
    stage.addEventListener('pointerout', (event) => {
      if (event.target === this.canvas_) this.listener_?.onHoverEnd?.();
    });
    stage.addEventListener(
      'wheel',
      (event) => {
        if (event.target !== this.canvas_) return;
        event.preventDefault();
        this.tellPointer_(event, -event.deltaY / 100);
        if (event.shiftKey) this.turn_(event);
        else gestures.wheel(event);
      },
      { passive: false },
    );
    stage.addEventListener('contextmenu', (event) => event.preventDefault());
    stage.addEventListener('keydown', (event) => this.key_(event));
    stage.addEventListener('keyup', (event) => {
      if (event.key.toLowerCase() === 'b') this.listener_?.onBefore?.(false);
    });
    new ResizeObserver(() => this.announceSize()).observe(stage);
    this.watchPixelRatio_();
  }

  /** @param {ViewListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /**
   * Replaces the canvas by a new one, since a canvas handed to a worker cannot be taken back.
   * @returns {HTMLCanvasElement}
   */
  makeCanvas() {
    const canvas = document.createElement('canvas');
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'application');
    canvas.setAttribute('aria-label', '3D view');
    canvas.setAttribute('aria-describedby', 'view-help');
    if (this.canvas_) this.canvas_.replaceWith(canvas);
    else this.stage_.prepend(canvas); // below the overlays
    this.canvas_ = canvas;
    return canvas;
  }

  announceSize() {
    const { width, height } = this.stage_.getBoundingClientRect();
    if (width > 0 && height > 0) this.listener_?.onResize({ width, height, devicePixelRatio: pixelRatio() });
  }

  /** Returns the point in the middle of the view, in CSS pixels of the canvas. */
  middle_() {
    return { x: this.stage_.clientWidth / 2, y: this.stage_.clientHeight / 2 };
  }

  /** Adds up fractions of a notch and reports whole notches. @param {WheelEvent} event */
  turn_(event) {
    this.turned_ += notchesOf(event);
    const whole = Math.trunc(this.turned_);
    this.turned_ -= whole;
    if (whole !== 0) this.listener_?.onTurn?.(whole, event.offsetX, event.offsetY);
  }

  /** @param {MouseEvent} event @param {number} wheel */
  tellPointer_(event, wheel) {
    if (!this.reportsPointer) return;
    this.listener_?.onAct({ kind: 'pointer', x: event.offsetX, y: event.offsetY, buttons: event.buttons, wheel });
  }

  /** @param {KeyboardEvent} event */
  key_(event) {
    if (event.target !== this.canvas_ || event.ctrlKey || event.metaKey || event.altKey) return;
    const { x, y } = this.middle_();
    const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (arrow && event.shiftKey) {
      this.listener_?.onAct({ kind: 'pan', dx: arrow[0] * kKeyPanPx, dy: arrow[1] * kKeyPanPx });
    } else if (arrow) {
      this.listener_?.onAct({ kind: 'orbit', dx: arrow[0] * kKeyOrbitPx, dy: arrow[1] * kKeyOrbitPx });
    } else if (event.key === '+' || event.key === '=') {
      this.listener_?.onAct({ kind: 'zoom', factor: kKeyZoom, x, y });
    } else if (event.key === '-') {
      this.listener_?.onAct({ kind: 'zoom', factor: 1 / kKeyZoom, x, y });
    } else if (event.key.toLowerCase() === 'f') {
      this.listener_?.onAct({ kind: 'fit' });
    } else if (event.key.toLowerCase() === 'r') {
      this.listener_?.onAct({ kind: 'readerView' });
    } else if (kStandardViews[event.key]) {
      this.listener_?.onAct({ kind: 'standard', name: kStandardViews[event.key] });
    } else if (event.key.toLowerCase() === 'b') {
      this.listener_?.onBefore?.(true);
    } else if (event.key === 'Enter') {
      this.listener_?.onPick(x, y);
    } else {
      return;
    }
    event.preventDefault();
  }

  watchPixelRatio_() {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener(
      'change',
      () => {
        this.announceSize();
        this.watchPixelRatio_();
      },
      { once: true },
    );
  }
}

/**
 * Returns the notches of a wheel event, positive upwards. Browsers send several notches as one event, and trackpads
 * send fractions. With Shift, some systems send them sideways.
 * @param {WheelEvent} event
 */
const notchesOf = (event) => -(event.deltaY || event.deltaX) / [100, 3, 1][event.deltaMode];

const pixelRatio = () => Math.min(devicePixelRatio, kMaxPixelRatio);
