// SPDX-License-Identifier: GPL-3.0-or-later
// The height of the model over the build plate: a dimension line beside the model.
import { text } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { make } from '../dom/dom.js';

/** @typedef {import('../engine/types.js').PlateOnScreen} PlateOnScreen */

const kSvg = 'http://www.w3.org/2000/svg';
const kLeastPx = 24; // a shorter line, seen from above, says nothing
const kTickPx = 4; // half the stroke across each end
const kGapPx = 10; // between line and label
const kLeastXPx = 4; // of the label's left end: on a phone, the line is at the edge of the view
const kWholeFromMm = 100; // heights from here on are whole mm

export class HeightMark {
  /** @param {HTMLElement} overlay  covers the canvas */
  constructor(overlay) {
    const svg = document.createElementNS(kSvg, 'svg');
    svg.setAttribute('aria-hidden', 'true');
    this.lines_ = Array.from({ length: 3 }, () => document.createElementNS(kSvg, 'line'));
    svg.append(...this.lines_);
    this.label_ = make('span');
    this.mark_ = make('div', { className: 'height-mark' }, svg, this.label_);
    this.mark_.hidden = true;
    overlay.append(this.mark_);
    /** @type {number | undefined} */ this.heightMm_ = undefined;
  }

  /** @param {PlateOnScreen | null} plate */
  show(plate) {
    const lines = plate && heightLines(plate);
    this.mark_.hidden = !lines;
    if (!plate || !lines) return;
    lines.forEach(([x1, y1, x2, y2], at) => {
      for (const [key, value] of Object.entries({ x1, y1, x2, y2 }))
        this.lines_[at].setAttribute(key, value.toFixed(1));
    });
    const [x, y] = [0, 1].map((axis) => (plate.foot[axis] + plate.top[axis]) / 2);
    this.label_.style.transform = `translate(max(${kLeastXPx}px, ${x - kGapPx}px - 100%), calc(${y}px - 50%))`;
    if (plate.heightMm === this.heightMm_) return;
    const { heightMm } = plate;
    this.heightMm_ = heightMm;
    write(this.label_, () =>
      text('view.plateHeight', { mm: Number(heightMm.toFixed(heightMm < kWholeFromMm ? 1 : 0)) }),
    );
  }
}

/**
 * Returns the dimension line and the strokes across its ends.
 * @param {PlateOnScreen} plate
 * @returns {[number, number, number, number][] | null}  null if the line is too short on the screen
 */
export function heightLines({ foot, top }) {
  const [dx, dy] = [top[0] - foot[0], top[1] - foot[1]];
  const length = Math.hypot(dx, dy);
  if (length < kLeastPx) return null;
  const [acrossX, acrossY] = [(-dy * kTickPx) / length, (dx * kTickPx) / length];
  const tick = (/** @type {[number, number]} */ [x, y]) =>
    /** @type {[number, number, number, number]} */ ([x - acrossX, y - acrossY, x + acrossX, y + acrossY]);
  return [[...foot, ...top], tick(foot), tick(top)];
}
