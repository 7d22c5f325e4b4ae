// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the carved code back with ZXing-C++, a reader that shares nothing with our own code. Loaded when first needed.
import wasmUrl from 'zxing-wasm/reader/zxing_reader.wasm?url';

/** @typedef {import('../engine/types.js').GreyImage} GreyImage */
/** @typedef {import('zxing-wasm/reader').ReaderOptions} ReaderOptions */

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

/** Ways to look at the picture, the usual one first: a phone tries many within a second. */
const kTries = /** @type {ReaderOptions[]} */ ([
  { binarizer: 'LocalAverage' },
  { binarizer: 'GlobalHistogram' },
  { binarizer: 'LocalAverage', tryDenoise: true },
]);

/**
 * @param {GreyImage} image
 * @returns {Promise<string>}  the text, or '' if nothing could be read
 */
export async function readCode(image) {
  const { readBarcodes } = await loadLibrary();
  const data = toImageData(image);
  for (const options of kTries) {
    const [found] = await readBarcodes(data, { formats: ['QRCode'], tryHarder: true, maxNumberOfSymbols: 1, ...options });
    if (found?.isValid) return found.text;
  }
  return '';
}

/** @param {GreyImage} image */
function toImageData({ width, height, pixels }) {
  const data = new ImageData(width, height);
  for (let i = 0; i < width * height; i += 1) data.data.fill(pixels[i], 4 * i, 4 * i + 3).fill(255, 4 * i + 3, 4 * i + 4);
  return data;
}
