// SPDX-License-Identifier: GPL-3.0-or-later
// Decodes pictures with ZXing-C++, which shares no code with the engraver. Loaded on first use.
import wasmUrl from 'zxing-wasm/reader/zxing_reader.wasm?url';

/** @typedef {import('../engine/types.js').GreyImage} GreyImage */

const kBinarizers = /** @type {const} */ (['LocalAverage', 'GlobalHistogram']);

/** @type {Promise<typeof import('zxing-wasm/reader')> | undefined} */
let library;

/** Loads the decoder. Call it in advance: fetching and compiling take a moment. */
export function loadLibrary() {
  library ??= import('zxing-wasm/reader').then(async (reader) => {
    await reader.prepareZXingModule({ overrides: { locateFile: () => wasmUrl }, fireImmediately: true });
    return reader;
  });
  return library;
}

/**
 * Decodes each picture with each binariser in turn.
 * @param {GreyImage[]} pictures
 * @param {string} [text]      text at which to stop
 * @returns {Promise<string[]>}  text decoded in each try, '' if none
 */
export async function scan(pictures, text) {
  const { readBarcodes } = await loadLibrary();
  /** @type {string[]} */ const texts = [];
  for (const picture of pictures) {
    const data = toImageData(picture);
    for (const binarizer of kBinarizers) {
      const [symbol] = await readBarcodes(data, {
        formats: ['QRCode'],
        tryHarder: true,
        maxNumberOfSymbols: 1,
        binarizer,
      });
      texts.push(symbol?.isValid && !symbol.isMirrored ? symbol.text : '');
      if (text !== undefined && texts.at(-1) === text) return texts;
    }
  }
  return texts;
}

/** @param {GreyImage} image */
function toImageData({ width, height, pixels }) {
  const data = new ImageData(width, height);
  const words = new Uint32Array(data.data.buffer);
  for (let i = 0; i < words.length; i += 1) words[i] = 0xff000000 | (pixels[i] * 0x010101);
  return data;
}
