// SPDX-License-Identifier: GPL-3.0-or-later
// Turns pointer events into gestures: one pointer orbits (right or middle button, or Shift: pans), two pan and pinch, a
// still one clicks.

const kClickMouseSlopPx = 4;
const kClickTouchSlopPx = 10;
const kWheelZoomPerPx = 0.0015;
const kPinchWheelZoomPerPx = 0.01; // a trackpad sends a pinch as small wheel steps with Ctrl
const kWheelLinePx = 16;
const kWheelPagePx = 400;

/**
 * @typedef {object} GestureListener
 * @property {(dx: number, dy: number) => void} onOrbit
 * @property {(dx: number, dy: number) => void} onPan
 * @property {(factor: number, x: number, y: number) => void} onZoom  factor > 1 zooms in
 * @property {(x: number, y: number, alt: boolean) => void} onClick
 */

/** @typedef {{ x: number, y: number }} Position */
/** @typedef {{ clientX: number, clientY: number, offsetX: number, offsetY: number, pointerId: number,
 *   pointerType: string, button: number, buttons: number, shiftKey: boolean, altKey: boolean }} PointerLike */

export class GestureReader {
  /** @param {GestureListener} listener */
  constructor(listener) {
    this.listener_ = listener;
    /** @type {Map<number, Position>} */ this.pointers_ = new Map();
    this.travelPx_ = 0;
    this.mayClick_ = false;
  }

  /**
   * @param {'pointerdown' | 'pointermove' | 'pointerup' | 'pointercancel'} type
   * @param {PointerLike} event  offsets relative to the canvas
   */
  pointer(type, event) {
    if (type === 'pointerdown') this.down_(event);
    else if (type === 'pointermove') this.move_(event);
    else this.up_(event, type === 'pointerup');
  }

  /** @param {{ deltaY: number, deltaMode: number, ctrlKey: boolean, offsetX: number, offsetY: number }} event */
  wheel(event) {
    const pixels = event.deltaY * [1, kWheelLinePx, kWheelPagePx][event.deltaMode];
    const rate = event.ctrlKey ? kPinchWheelZoomPerPx : kWheelZoomPerPx;
    this.listener_.onZoom(Math.exp(-pixels * rate), event.offsetX, event.offsetY);
  }

  /** @param {PointerLike} event */
  down_(event) {
    if (this.pointers_.size === 0) {
      this.travelPx_ = 0;
      this.mayClick_ = event.button === 0 && !event.shiftKey;
    } else {
      this.mayClick_ = false;
    }
    this.pointers_.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
  }

  /** @param {PointerLike} event */
  move_(event) {
    const last = this.pointers_.get(event.pointerId);
    if (!last) return;
    const now = { x: event.offsetX, y: event.offsetY };
    const [dx, dy] = [now.x - last.x, now.y - last.y];
    this.travelPx_ += Math.hypot(dx, dy);
    if (this.mayClick_ && this.travelPx_ <= slopPx(event)) return; // keeps `last`, so no movement is lost
    this.mayClick_ = false;
    const other = [...this.pointers_].find(([id]) => id !== event.pointerId)?.[1];
    this.pointers_.set(event.pointerId, now);
    if (other) this.pinch_(last, now, other);
    else if (event.shiftKey || (event.buttons & 6) !== 0) this.listener_.onPan(dx, dy);
    else this.listener_.onOrbit(dx, dy);
  }

  /** @param {Position} last @param {Position} now @param {Position} other */
  pinch_(last, now, other) {
    this.listener_.onPan((now.x - last.x) / 2, (now.y - last.y) / 2);
    const before = Math.hypot(last.x - other.x, last.y - other.y);
    const after = Math.hypot(now.x - other.x, now.y - other.y);
    if (before > 0 && after > 0) {
      this.listener_.onZoom(after / before, (now.x + other.x) / 2, (now.y + other.y) / 2);
    }
  }

  /** @param {PointerLike} event @param {boolean} completed */
  up_(event, completed) {
    const known = this.pointers_.delete(event.pointerId);
    if (known && completed && this.mayClick_) this.listener_.onClick(event.offsetX, event.offsetY, event.altKey);
    this.mayClick_ = false;
  }
}

/** @param {PointerLike} event */
const slopPx = (event) => (event.pointerType === 'mouse' ? kClickMouseSlopPx : kClickTouchSlopPx);
