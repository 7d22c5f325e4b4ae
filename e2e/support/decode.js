// SPDX-License-Identifier: GPL-3.0-or-later
// Decodes a QR code outside the page.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { prepareZXingModule, readBarcodes } from 'zxing-wasm/reader';

const wasm = readFileSync(createRequire(import.meta.url).resolve('zxing-wasm/reader/zxing_reader.wasm'));
prepareZXingModule({
  overrides: { wasmBinary: wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength) },
});

/** @typedef {{ data: Uint8ClampedArray, width: number, height: number }} Picture */

const kPixelsPerModule = 4;

/**
 * Decodes a QR code from an SVG's path of unit-high bars, without rendering the SVG.
 * @param {string} path  `M4 4h7v1h-7z…`
 * @param {number} edge  of the picture, in the SVG's units
 * @returns {Promise<string>}  '' if no code is found
 */
export async function decodePath(path, edge) {
  const width = edge * kPixelsPerModule;
  const picture = /** @type {Picture} */ ({
    data: new Uint8ClampedArray(4 * width * width).fill(255),
    width,
    height: width,
  });
  for (const [, x, y, length] of path.matchAll(/M(\d+) (\d+)h(\d+)v1h-\3z/g)) {
    for (let row = 0; row < kPixelsPerModule; row += 1) {
      const begin = (Number(y) * kPixelsPerModule + row) * width + Number(x) * kPixelsPerModule;
      for (let i = begin; i < begin + Number(length) * kPixelsPerModule; i += 1) picture.data.fill(0, 4 * i, 4 * i + 3);
    }
  }
  const [symbol] = await readBarcodes(/** @type {ImageData} */ (/** @type {unknown} */ (picture)), {
    formats: ['QRCode'],
    tryHarder: true,
  });
  return symbol?.isValid ? symbol.text : '';
}

/**
 * Finds a QR code and its corners.
 * @param {Uint8Array} png
 * @returns {Promise<import('zxing-wasm/reader').ReadResult | undefined>}
 */
export async function findCode(png) {
  for (const tryDenoise of [false, true]) {
    // denoising closes the gaps between the squares of a pattern
    const [symbol] = await readBarcodes(new Uint8Array(png), { formats: ['QRCode'], tryHarder: true, tryDenoise });
    if (symbol?.isValid) return symbol;
  }
  return undefined;
}

/**
 * @param {Uint8Array} png
 * @returns {Promise<string>}  '' if no code is found
 */
export async function decodePng(png) {
  return (await findCode(png))?.text ?? '';
}
