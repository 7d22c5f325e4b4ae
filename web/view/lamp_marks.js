// SPDX-License-Identifier: GPL-3.0-or-later
// The lamps that the code is carved for, drawn over the model: each as a sun with a line towards the code. Dragging a
// sun moves its lamp round the code; the engine shows every move at once.
import { isReplaced } from '../engine/client.js';
import { text } from '../i18n/catalogue.js';
import { NewestOnly } from './newest_only.js';

/** @typedef {import('../engine/lamps.js').Lamp} Lamp */
/** @typedef {import('../engine/types.js').LampOnScreen} LampOnScreen */
/** @typedef {[number, number]} Point */

/**
 * @typedef {object} LampListener
 * @property {(light: Lamp[]) => void} onLight  the lamps after one was dragged
 * @property {() => void} onCancel              discard the preview
 */

const kSvg = 'http://www.w3.org/2000/svg';
const kSunPx = 7,
  kRayPx = [10, 14],
  kRays = 8;
const kHeldPx = 22; // a finger this near holds the sun
const kGapPx = 16; // from the sun's middle to the line
const kClickSlopPx = 3;
const kPointerEvents = /** @type {const} */ (['pointermove', 'pointerup', 'pointercancel']);

export class LampMarks {
  /**
   * @param {object} options
   * @param {Pick<import('../engine/client.js').EngineClient, 'moveLamp'>} options.client
   * @param {HTMLElement} options.overlay  covers the canvas
   * @param {LampListener} options.listener
   */
  constructor({ client, overlay, listener }) {
    this.client_ = client;
    this.listener_ = listener;
    this.svg_ = svg('svg', 'lamp-marks');
    this.svg_.setAttribute('aria-hidden', 'true'); // the lamp fields give the same information
    overlay.append(this.svg_);
    /** @type {LampMark[]} */ this.marks_ = [];
    /** The lamp that is held. @type {{ lamp: number, pointerId: number, from: Point, offset: Point, moved: boolean } | undefined} */
    this.drag_ = undefined;
    this.queue_ = new NewestOnly((/** @type {{ lamp: number, at: Point, isLast: boolean }} */ move) =>
      this.move_(move),
    );
    this.follow_ = (/** @type {PointerEvent} */ event) => this.dragged_(event);
    this.escape_ = (/** @type {KeyboardEvent} */ event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      this.cancel_();
    };
  }

  /** @param {boolean} isEnabled  the settings may be changed */
  setEnabled(isEnabled) {
    this.svg_.classList.toggle('held-by-pointer', isEnabled);
    if (!isEnabled && this.drag_) this.cancel_();
  }

  /** @param {readonly LampOnScreen[]} lamps */
  show(lamps) {
    while (this.marks_.length < lamps.length) this.marks_.push(this.newMark_(this.marks_.length));
    this.marks_.forEach((mark, at) => mark.show(lamps[at], lamps.length > 1));
  }

  /** @param {number} lamp */
  newMark_(lamp) {
    const mark = new LampMark(lamp + 1);
    mark.element.addEventListener('pointerdown', (event) => this.hold_(lamp, event));
    this.svg_.append(mark.element);
    return mark;
  }

  /** @param {number} lamp @param {PointerEvent} event */
  hold_(lamp, event) {
    if (event.button !== 0 || this.drag_) return;
    event.preventDefault();
    event.stopPropagation();
    const from = this.positionOf_(event);
    const [x, y] = this.marks_[lamp].at;
    this.drag_ = { lamp, pointerId: event.pointerId, from, offset: [x - from[0], y - from[1]], moved: false };
    this.svg_.classList.add('dragging');
    for (const type of kPointerEvents) addEventListener(type, this.follow_, { capture: true });
    addEventListener('keydown', this.escape_, { capture: true });
  }

  /** @param {PointerEvent} event */
  dragged_(event) {
    const { drag_: drag } = this;
    if (!drag) return;
    event.stopPropagation();
    if (event.pointerId !== drag.pointerId) return;
    if (event.type === 'pointercancel') {
      this.cancel_();
      return;
    }
    const [x, y] = this.positionOf_(event);
    drag.moved ||= Math.hypot(x - drag.from[0], y - drag.from[1]) > kClickSlopPx;
    const isLast = event.type === 'pointerup';
    if (isLast) this.release_();
    if (drag.moved) this.queue_.ask({ lamp: drag.lamp, at: [x + drag.offset[0], y + drag.offset[1]], isLast });
  }

  /** @param {{ lamp: number, at: Point, isLast: boolean }} move */
  async move_({ lamp, at, isLast }) {
    try {
      const light = await this.client_.moveLamp({ lamp, at });
      if (isLast) this.listener_.onLight(light);
    } catch (thrown) {
      if (!isReplaced(thrown) && isLast) this.listener_.onCancel();
    }
  }

  cancel_() {
    this.release_();
    this.queue_.forget();
    this.listener_.onCancel();
  }

  release_() {
    this.drag_ = undefined;
    this.svg_.classList.remove('dragging');
    for (const type of kPointerEvents) removeEventListener(type, this.follow_, { capture: true });
    removeEventListener('keydown', this.escape_, { capture: true });
  }

  /** @param {PointerEvent} event @returns {Point} */
  positionOf_(event) {
    const { left, top } = this.svg_.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }
}

/** One lamp. Its elements stay while it moves, so that a finger keeps its hold. */
class LampMark {
  /** @param {number} number */
  constructor(number) {
    this.element = svg('g');
    this.way_ = svg('line', 'way');
    const rays = Array.from({ length: kRays }, (_, ray) => {
      const angle = (2 * Math.PI * ray) / kRays,
        direction = [Math.cos(angle), Math.sin(angle)];
      return setLine(
        svg('line', 'ray'),
        direction.map((value) => value * kRayPx[0]),
        direction.map((value) => value * kRayPx[1]),
      );
    });
    this.number_ = Object.assign(svg('text'), { textContent: String(number) });
    this.title_ = svg('title');
    this.element.append(this.title_, this.way_, circle('hold', kHeldPx), ...rays, circle('sun', kSunPx), this.number_);
    /** @type {Point} */ this.at = [0, 0];
  }

  /** @param {LampOnScreen | undefined} lamp @param {boolean} isNumbered */
  show(lamp, isNumbered) {
    this.element.toggleAttribute('hidden', !lamp?.from);
    if (!lamp?.from) return;
    this.at = lamp.from;
    this.element.setAttribute('transform', `translate(${this.at.map((value) => value.toFixed(1)).join(' ')})`);
    this.number_.toggleAttribute('hidden', !isNumbered);
    this.title_.textContent = text('view.dragLamp');
    const [dx, dy] = [lamp.to[0] - this.at[0], lamp.to[1] - this.at[1]],
      length = Math.hypot(dx, dy);
    this.way_.toggleAttribute('hidden', length <= 2 * kGapPx);
    setLine(
      this.way_,
      [dx, dy].map((value) => (value * kGapPx) / Math.max(length, kGapPx)),
      [dx, dy].map((value) => value / 2),
    );
  }
}

/**
 * @template {keyof SVGElementTagNameMap} Name
 * @param {Name} name
 * @param {string} [className]
 */
function svg(name, className) {
  const element = document.createElementNS(kSvg, name);
  if (className) element.classList.add(className);
  return element;
}

/** @param {string} className @param {number} radius */
function circle(className, radius) {
  const element = svg('circle', className);
  element.setAttribute('r', String(radius));
  return element;
}

/** @param {SVGLineElement} element @param {number[]} from @param {number[]} to */
function setLine(element, from, to) {
  for (const [key, value] of Object.entries({ x1: from[0], y1: from[1], x2: to[0], y2: to[1] }))
    element.setAttribute(key, value.toFixed(1));
  return element;
}
