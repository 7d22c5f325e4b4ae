// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the page's letters for the inspector: its library has only a coarse font.

const kFamily = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "Liberation Sans", sans-serif';
const kMarginPx = 2; // empty border, so that interpolation never picks up a neighbouring letter
const kLineHeight = 1.3; // as a multiple of the letter size

/** Printable ASCII, and the other letters of the inspector's English texts. */
const kEnglish = String.fromCodePoint(...Array.from({ length: 0x7f - 0x20 }, (_, i) => 0x20 + i)) + '×·°„“”…';

/** Returns the letters that the inspector needs to show texts. @param {string[]} texts */
export const lettersOf = (texts) => [...new Set(kEnglish + texts.join(''))].join('');

/**
 * @typedef {object} Glyphs
 * @property {number} lineHeight
 * @property {Float32Array} metrics  six numbers per letter: code point, width, height, left, top, advance
 * @property {Uint8Array} alpha      opacity, letter by letter, row by row
 */

/**
 * Draws letters.
 * @param {string} letters
 * @param {number} sizePx  letter size, device pixels
 * @returns {Glyphs | null}  null without OffscreenCanvas or its 2D context
 */
export function drawGlyphs(letters, sizePx) {
  const edge = Math.ceil(sizePx * 2);
  const context =
    typeof OffscreenCanvas === 'function'
      ? /** @type {OffscreenCanvasRenderingContext2D | null} */ (
          new OffscreenCanvas(edge, edge).getContext('2d', { willReadFrequently: true })
        )
      : null;
  if (!context) return null;
  context.font = `${sizePx}px ${kFamily}`;
  context.textBaseline = 'alphabetic';
  context.fillStyle = '#fff';
  const lineHeight = Math.round(sizePx * kLineHeight);
  const baseline = Math.round((lineHeight - sizePx) / 2 + sizePx * 0.8);
  const metrics = [];
  const pictures = [];
  for (const letter of letters) {
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
