// SPDX-License-Identifier: GPL-3.0-or-later
// The progress of the depth search: the light in its newest pass and the depths that it tried, as the code's viewer
// sees them.
import { byId } from '../dom/dom.js';
import { paintDepths, paintLight } from './map_colours.js';

export class SearchPicture {
  constructor() {
    this.figure_ = byId('search', HTMLElement);
    this.light_ = byId('search-light', HTMLCanvasElement);
    this.depths_ = byId('search-depths', HTMLCanvasElement);
  }

  /** @param {import('../engine/types.js').SearchMaps} search */
  show({ luminance, depths }) {
    paintOn(this.light_, paintLight(luminance));
    paintOn(this.depths_, paintDepths(depths));
    this.figure_.hidden = false;
  }

  hide() {
    this.figure_.hidden = true;
  }
}

/** @param {HTMLCanvasElement} canvas @param {import('./map_colours.js').Pixels} pixels */
function paintOn(canvas, { width, height, rgba }) {
  Object.assign(canvas, { width, height });
  canvas.getContext('2d')?.putImageData(new ImageData(rgba, width, height), 0, 0);
}
