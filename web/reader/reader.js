// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the carved code back with ZXing-C++, a reader that shares nothing with our own code. Loaded when first needed.
import wasmUrl from 'zxing-wasm/reader/zxing_reader.wasm?url';
import { frontalPictures, readingVariants } from './variants.js';

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

/** @typedef {{ text: string, tries: number, reads: number }} Reading
 *   `text`: what was read, '' if nothing; `reads`: in so many of the tries */

/**
 * Everything that a scanning app tries, on pictures from the front that differ in scale and focus.
 * @param {GreyImage} image
 * @param {number} pixelsPerModule  of the code in it
 * @returns {Promise<Reading>}
 */
export async function readAll(image, pixelsPerModule) {
  /** @type {Reading} */ const reading = { text: '', tries: 0, reads: 0 };
  for (const frontal of frontalPictures(image, pixelsPerModule)) {
    for await (const text of tries(frontal.picture, frontal.pixelsPerModule)) {
      reading.tries += 1;
      if (text === '') continue;
      reading.text ||= text;
      if (text === reading.text) reading.reads += 1;
    }
    await new Promise((resolve) => setTimeout(resolve));  // the page stays responsive
  }
  return reading;
}

/** Whether any of it succeeds on one picture. @param {GreyImage} image @param {number} pixelsPerModule @param {string} wanted */
export async function reads(image, pixelsPerModule, wanted) {
  for await (const text of tries(image, pixelsPerModule)) if (text === wanted) return true;
  return false;
}

/** @param {GreyImage} image @param {number} pixelsPerModule */
async function* tries(image, pixelsPerModule) {
  const { readBarcodes } = await loadLibrary();
  for (const variant of readingVariants(image, pixelsPerModule)) {
    const data = toImageData(variant);
    for (const binarizer of /** @type {const} */ (['LocalAverage', 'GlobalHistogram'])) {
      const [found] = await readBarcodes(data, { formats: ['QRCode'], tryHarder: true, maxNumberOfSymbols: 1, binarizer });
      yield found?.isValid ? found.text : '';
    }
  }
}

/** @param {GreyImage} image */
function toImageData({ width, height, pixels }) {
  const data = new ImageData(width, height);
  const words = new Uint32Array(data.data.buffer);
  for (let i = 0; i < words.length; i += 1) words[i] = 0xff000000 | (pixels[i] * 0x010101);
  return data;
}
