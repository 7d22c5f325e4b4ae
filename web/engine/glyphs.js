// SPDX-License-Identifier: GPL-3.0-or-later
// The page's own letters for the inspector, whose library has only a coarse font of its own.

const kFamily = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "Liberation Sans", sans-serif';
const kMarginPx = 2;     // clear on all sides, so that no letter shows a neighbour's edge between two pixels
const kLineHeight = 1.3;  // of the letters' size

const range = (/** @type {number} */ from, /** @type {number} */ to) =>
  Array.from({ length: to - from + 1 }, (_, i) => String.fromCodePoint(from + i)).join('');

/** Printable ASCII, Latin-1 and what else the inspector's texts have. */
export const kLetters = range(0x20, 0x7e) + range(0xa1, 0xff) + '„“';

/**
 * @typedef {object} Glyphs
 * @property {number} lineHeight
 * @property {Float32Array} metrics  six numbers a letter: code point, width, height, left, top, advance
 * @property {Uint8Array} alpha      of one letter after the other, row by row
 */

/**
 * @param {number} sizePx  of the letters, in device pixels
 * @returns {Glyphs | null}  null where nothing can be drawn apart from the page
 */
export function drawGlyphs(sizePx) {
  const edge = Math.ceil(sizePx * 2);
  const context = typeof OffscreenCanvas === 'function'
    ? /** @type {OffscreenCanvasRenderingContext2D | null} */ (new OffscreenCanvas(edge, edge).getContext('2d', { willReadFrequently: true })) : null;
  if (!context) return null;
  context.font = `${sizePx}px ${kFamily}`;
  context.textBaseline = 'alphabetic';
  context.fillStyle = '#fff';
  const lineHeight = Math.round(sizePx * kLineHeight);
  const baseline = Math.round((lineHeight - sizePx) / 2 + sizePx * 0.8);
  const metrics = [];
  const pictures = [];
  for (const letter of kLetters) {
    const measured = context.measureText(letter);
    const left = Math.floor(-measured.actualBoundingBoxLeft) - kMarginPx;
    const above = Math.ceil(measured.actualBoundingBoxAscent) + kMarginPx;
    const width = Math.min(edge, Math.ceil(measured.actualBoundingBoxRight) + kMarginPx - left);
    const height = Math.min(edge, above + Math.ceil(measured.actualBoundingBoxDescent) + kMarginPx);
    context.clearRect(0, 0, edge, edge);
    context.fillText(letter, -left, above);
    const { data } = context.getImageData(0, 0, width, height);
    pictures.push(Uint8Array.from({ length: width * height }, (_, i) => data[4 * i + 3]));
    metrics.push(letter.codePointAt(0) ?? 0, width, height, left, baseline - above, measured.width);
  }
  const alpha = new Uint8Array(pictures.reduce((sum, { length }) => sum + length, 0));
  pictures.reduce((at, picture) => {
    alpha.set(picture, at);
    return at + picture.length;
  }, 0);
  return { lineHeight, metrics: Float32Array.from(metrics), alpha };
}
