// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of the printed code over the code in the view. It marks the modules that the print has lost.
import { make } from '../dom/dom.js';

/** @typedef {import('../engine/types.js').Print} Print */
/** @typedef {import('../engine/types.js').CodeOnScreen} CodeOnScreen */

const kPictureMarginModules = 6; // margin around the symbol within the picture
const kMark = 'rgb(255 64 32 / 90%)';

export class PrintPicture {
  /** @param {HTMLElement} overlay  covers the canvas */
  constructor(overlay) {
    this.canvas_ = make('canvas', { className: 'print-picture' });
    this.canvas_.hidden = true;
    this.canvas_.setAttribute('aria-hidden', 'true'); // the caption gives the same information
    overlay.append(this.canvas_);
    this.modules_ = 0;
    /** @type {CodeOnScreen | null} */ this.code_ = null;
  }

  /** @param {Print} print @param {number} modules  along the symbol's edge */
  show({ picture, misread }, modules) {
    const { width, height, pixels } = picture;
    Object.assign(this.canvas_, { width, height });
    const drawing = /** @type {CanvasRenderingContext2D} */ (this.canvas_.getContext('2d'));
    drawing.putImageData(
      new ImageData(
        Uint8ClampedArray.from({ length: 4 * pixels.length }, (_, i) => (i % 4 === 3 ? 255 : pixels[i >> 2])),
        width,
        height,
      ),
      0,
      0,
    );
    const module = width / (modules + 2 * kPictureMarginModules);
    drawing.strokeStyle = kMark;
    drawing.lineWidth = module / 8;
    for (const [row, column] of misread) {
      const [x, y] = [column, row].map((place) => (place + kPictureMarginModules) * module);
      drawing.strokeRect(
        x + drawing.lineWidth,
        y + drawing.lineWidth,
        module - 2 * drawing.lineWidth,
        module - 2 * drawing.lineWidth,
      );
    }
    this.modules_ = modules;
    this.canvas_.hidden = false;
    this.place(this.code_);
  }

  hide() {
    this.canvas_.hidden = true;
  }

  /** @param {CodeOnScreen | null} code  its position on the screen now */
  place(code) {
    this.code_ = code;
    if (this.canvas_.hidden || !code) return;
    const [upperLeft, upperRight, lowerRight] = code.corners;
    const edge = Math.hypot(upperRight[0] - upperLeft[0], upperRight[1] - upperLeft[1]);
    const turn = Math.atan2(upperRight[1] - upperLeft[1], upperRight[0] - upperLeft[0]);
    const symbolPx = (edge * code.symbolMm) / code.edgeMm;
    const edgePx = (symbolPx * (this.modules_ + 2 * kPictureMarginModules)) / this.modules_;
    const [x, y] = [0, 1].map((axis) => (upperLeft[axis] + lowerRight[axis]) / 2);
    this.canvas_.style.transform = `translate(${x}px, ${y}px) rotate(${turn}rad) scale(${edgePx / this.canvas_.width}) translate(-50%, -50%)`;
  }
}
