// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the symbol with its quiet zone as SVG and PNG.

export const kQuietZone = 4; // modules [ISO/IEC 18004, 6.3.8]
const kPngPixels = 1024; // smallest edge of the PNG

/**
 * Returns the runs of dark modules in a row, by first column and length.
 * @param {string} row  '1' = dark
 */
const runs = (row) => [...row.matchAll(/1+/g)].map(({ index, 0: { length } }) => ({ from: index, length }));

/**
 * Returns the dark modules as one path. A module is one unit; the origin is the quiet zone's upper left corner.
 * @param {string[]} rows
 */
export const symbolPath = (rows) =>
  rows
    .flatMap((row, y) =>
      runs(row).map(({ from, length }) => `M${from + kQuietZone} ${y + kQuietZone}h${length}v1h-${length}z`),
    )
    .join('');

/** Returns the symbol's edge with quiet zone, modules. @param {string[]} rows */
export const symbolEdge = (rows) => rows.length + 2 * kQuietZone;

/** @param {string} text */
const escapeXml = (text) =>
  text
    .replace(/[&<>"]/g, (character) => `&#${character.charCodeAt(0)};`)
    .replace(/[^\t\n\r\x20-\ud7ff\ue000-\ufffd\u{10000}-\u{10ffff}]/gu, '\ufffd');

/**
 * Writes the symbol as SVG.
 * @param {string[]} rows
 * @param {{ title: string, sizeMm?: number }} options
 *   `title`: for screen readers; `sizeMm`: edge of the symbol without quiet zone; if absent, the SVG has no intrinsic
 *   size
 */
export function symbolSvg(rows, { title, sizeMm }) {
  const edge = symbolEdge(rows);
  const size =
    sizeMm === undefined
      ? ''
      : ['width', 'height']
          .map((name) => ` ${name}="${Number(((sizeMm * edge) / rows.length).toFixed(3))}mm"`)
          .join('');
  return [
    `<svg xmlns="http://www.w3.org/2000/svg"${size} viewBox="0 0 ${edge} ${edge}" shape-rendering="crispEdges">`,
    `<title>${escapeXml(title)}</title>`,
    `<path fill="#fff" d="M0 0h${edge}v${edge}h-${edge}z"/>`,
    `<path d="${symbolPath(rows)}"/>`,
    '</svg>',
    '',
  ].join('\n');
}

/**
 * Draws the symbol with a whole number of pixels per module.
 * @param {string[]} rows
 * @returns {{ edge: number, pixels: Uint8ClampedArray<ArrayBuffer> }}  RGBA
 */
export function symbolPixels(rows) {
  const scale = Math.ceil(kPngPixels / symbolEdge(rows));
  const edge = scale * symbolEdge(rows);
  const pixels = new Uint8ClampedArray(4 * edge * edge).fill(255);
  const words = new Uint32Array(pixels.buffer);
  const black = new Uint32Array(new Uint8Array([0, 0, 0, 255]).buffer)[0];
  rows.forEach((row, y) => {
    for (const { from, length } of runs(row)) {
      for (let line = 0; line < scale; line += 1) {
        const begin = ((y + kQuietZone) * scale + line) * edge + (from + kQuietZone) * scale;
        words.fill(black, begin, begin + length * scale);
      }
    }
  });
  return { edge, pixels };
}

/** @param {string[]} rows @returns {Promise<Blob>} */
export async function symbolPng(rows) {
  const { edge, pixels } = symbolPixels(rows);
  const canvas = document.createElement('canvas');
  canvas.width = edge;
  canvas.height = edge;
  const context = canvas.getContext('2d');
  if (!context) throw new Error('The browser gives no canvas to draw the symbol on');
  context.putImageData(new ImageData(pixels, edge, edge), 0, 0);
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error('The browser could not write the picture'))),
      'image/png',
    );
  });
}
