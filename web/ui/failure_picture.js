// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a failed result: what a phone sees, or the print with the modules that it has lost.
import { text } from '../i18n/catalogue.js';
import { make } from '../dom/dom.js';
import { lostMarks } from '../view/lost_modules.js';

/** @typedef {import('../engine/types.js').GreyImage} GreyImage */

const kSvg = 'http://www.w3.org/2000/svg';
const kBorder = 6; // modules around the symbol in a picture
const kShownBorder = 3;

/**
 * Returns the picture that shows why the result failed; none if no picture does.
 * @param {'reads' | 'prints' | 'solid'} failed
 * @param {import('./result_panel.js').Result} result
 * @returns {HTMLElement[]}
 */
export function failurePicture(failed, { report, printed, seen }) {
  if (!report.symbol) return [];
  const { modules } = report.symbol;
  if (failed === 'reads' && seen) return [figure(crop(seen, modules), text('check.seenByPhone'))];
  if (failed !== 'prints' || printed?.state !== 'made') return [];
  const { misread, picture } = printed.print;
  const caption = text('check.lostInPrint', { count: misread.length });
  return [figure(crop(picture, modules), caption, marksOver(modules, misread))];
}

/** @param {HTMLCanvasElement} picture @param {string} caption @param {Element[]} over */
const figure = (picture, caption, ...over) =>
  make(
    'figure',
    { className: 'failure-picture' },
    make('div', {}, picture, ...over),
    make('figcaption', { text: caption }),
  );

/** Draws the middle of a picture. @param {GreyImage} picture @param {number} modules  along the symbol's edge */
function crop({ width, height, pixels }, modules) {
  const canvas = make('canvas');
  canvas.setAttribute('aria-hidden', 'true'); // the caption says what it shows
  const hidden = ((kBorder - kShownBorder) * width) / (modules + 2 * kBorder);
  canvas.width = canvas.height = Math.round(width - 2 * hidden);
  const image = new ImageData(width, height);
  new Uint32Array(image.data.buffer).set(Uint32Array.from(pixels, (grey) => 0xff000000 | (grey * 0x010101)));
  canvas.getContext('2d')?.putImageData(image, -Math.round(hidden), -Math.round(hidden));
  return canvas;
}

/** @param {number} modules @param {import('../engine/types.js').Print['misread']} misread */
function marksOver(modules, misread) {
  const svg = document.createElementNS(kSvg, 'svg');
  const edge = modules + 2 * kShownBorder;
  svg.classList.add('lost-modules');
  svg.setAttribute('viewBox', `${-kShownBorder} ${-kShownBorder} ${edge} ${edge}`);
  svg.setAttribute('aria-hidden', 'true');
  svg.append(...lostMarks(misread));
  return svg;
}
