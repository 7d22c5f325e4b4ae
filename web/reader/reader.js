// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the carved code back with ZXing-C++, a reader that shares nothing with our own code. Loaded when first needed.
import wasmUrl from 'zxing-wasm/reader/zxing_reader.wasm?url';
import { readingVariants } from './variants.js';

/** @typedef {import('../engine/types.js').GreyImage} GreyImage */

export const kReaderName = 'ZXing-C++ (zxing-wasm)';

/** @type {Promise<typeof import('zxing-wasm/reader')> | undefined} */
let library;

function loadLibrary() {
  library ??= import('zxing-wasm/reader').then((reader) => {
    reader.prepareZXingModule({ overrides: { locateFile: () => wasmUrl } });
    return reader;
  });
  return library;
}

/**
 * @param {GreyImage} image
 * @returns {Promise<string>}  the text, or '' if nothing could be read
 */
export async function readCode(image) {
  const { readBarcodes } = await loadLibrary();
  for (const variant of readingVariants(image)) {
    const data = toImageData(variant);
    for (const binarizer of /** @type {const} */ (['LocalAverage', 'GlobalHistogram'])) {
      const [found] = await readBarcodes(data, { formats: ['QRCode'], tryHarder: true, maxNumberOfSymbols: 1, binarizer });
      if (found?.isValid) return found.text;
    }
  }
  return '';
}

/** @param {GreyImage} image */
function toImageData({ width, height, pixels }) {
  const data = new ImageData(width, height);
  const words = new Uint32Array(data.data.buffer);
  for (let i = 0; i < words.length; i += 1) words[i] = 0xff000000 | (pixels[i] * 0x010101);
  return data;
}
