// SPDX-License-Identifier: GPL-3.0-or-later
// Marks the modules that a print has lost: over the code in the phone view, and in pictures.

/** @typedef {import('../engine/types.js').CodeOnScreen} CodeOnScreen */

const kSvg = 'http://www.w3.org/2000/svg';
const kInset = 0.125; // of a mark in its module

/** Returns a mark for each lost module, in modules from the symbol's top left. @param {import('../engine/types.js').Print['misread']} misread */
export const lostMarks = (misread) =>
  misread.map(([row, column]) => {
    const mark = document.createElementNS(kSvg, 'rect');
    const place = { x: column + kInset, y: row + kInset, width: 1 - 2 * kInset, height: 1 - 2 * kInset };
    for (const [key, value] of Object.entries(place)) mark.setAttribute(key, String(value));
    return mark;
  });

export class LostModules {
  /** @param {HTMLElement} overlay  covers the canvas */
  constructor(overlay) {
    this.svg_ = document.createElementNS(kSvg, 'svg');
    this.svg_.classList.add('lost-modules');
    this.svg_.setAttribute('aria-hidden', 'true'); // the caption counts them
    this.marks_ = document.createElementNS(kSvg, 'g');
    this.svg_.append(this.marks_);
    overlay.append(this.svg_);
    this.modules_ = 1;
    /** @type {CodeOnScreen | null} */ this.code_ = null;
  }

  /** @param {import('../engine/types.js').Print['misread']} misread @param {number} modules  along the symbol's edge */
  show(misread, modules) {
    this.modules_ = modules;
    this.marks_.replaceChildren(...lostMarks(misread));
    this.place(this.code_);
  }

  hide() {
    this.marks_.replaceChildren();
  }

  /** @param {CodeOnScreen | null} code  its position on the screen now */
  place(code) {
    this.code_ = code;
    if (!code) return;
    const [upperLeft, upperRight, lowerRight] = code.corners;
    const [across, down] = [upperRight[0] - upperLeft[0], upperRight[1] - upperLeft[1]];
    const modulePx = (Math.hypot(across, down) * code.symbolMm) / code.edgeMm / this.modules_;
    const turnDeg = (Math.atan2(down, across) * 180) / Math.PI;
    const middle = [0, 1].map((axis) => (upperLeft[axis] + lowerRight[axis]) / 2);
    const half = -this.modules_ / 2;
    this.marks_.setAttribute(
      'transform',
      `translate(${middle.join(' ')}) rotate(${turnDeg}) scale(${modulePx}) translate(${half} ${half})`,
    );
  }
}
