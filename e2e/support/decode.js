// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a QR code from a PNG, outside the page.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { prepareZXingModule, readBarcodes } from 'zxing-wasm/reader';

const wasm = readFileSync(createRequire(import.meta.url).resolve('zxing-wasm/reader/zxing_reader.wasm'));
prepareZXingModule({ overrides: { wasmBinary: wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength) } });

/**
 * @param {Uint8Array} png
 * @returns {Promise<string>}  '' if there is none
 */
export async function decodePng(png) {
  for (const tryDenoise of [false, true]) {  // which closes the gaps between the squares of a pattern
    const [found] = await readBarcodes(new Uint8Array(png), { formats: ['QRCode'], tryHarder: true, tryDenoise });
    if (found?.isValid) return found.text;
  }
  return '';
}
