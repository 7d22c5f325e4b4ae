// SPDX-License-Identifier: GPL-3.0-or-later
// QR decoders from npm, behind one interface; script/decoders installs them.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

/** @typedef {{ width: number, height: number, grey: Uint8Array, rgba: Uint8ClampedArray }} Picture row 0 at the top */

const requireFrom = (/** @type {string} */ peers) => createRequire(`${peers}/package.json`);

/**
 * @param {Uint8Array} grey
 * @returns {Picture}
 */
export function pictureOf(grey, /** @type {number} */ width, /** @type {number} */ height) {
  const rgba = new Uint8ClampedArray(4 * grey.length).fill(255);
  for (let i = 0; i < grey.length; i += 1) rgba.fill(grey[i], 4 * i, 4 * i + 3);
  return { width, height, grey, rgba };
}

/**
 * Reads a grey PNG.
 * @param {string} peers  the folder in which the packages are installed
 */
export function readPicture(peers, /** @type {string} */ file) {
  const { width, height, data } = requireFrom(peers)('pngjs').PNG.sync.read(readFileSync(file));
  return pictureOf(
    Uint8Array.from({ length: width * height }, (_, i) => data[4 * i]),
    width,
    height,
  );
}

/**
 * Returns functions from a picture to its text, or nothing, each with its decoder's own thorough settings.
 * @param {string} peers  the folder in which the packages are installed
 * @returns {Promise<Record<string, (picture: Picture) => string | undefined | Promise<string | undefined>>>}
 */
export async function npmDecoders(peers) {
  const require = requireFrom(peers);
  const imported = (/** @type {string} */ name) => import(pathToFileURL(require.resolve(name)).href);
  const [jsqr, zxing] = [require('jsqr'), require('@zxing/library')];
  const [zxingWasm, qr, zbar] = [
    await imported('zxing-wasm/reader'),
    await imported('qr/decode.js'),
    await imported('@undecaf/zbar-wasm'),
  ];
  zxingWasm.prepareZXingModule({
    overrides: { wasmBinary: readFileSync(`${peers}/node_modules/zxing-wasm/dist/reader/zxing_reader.wasm`).buffer },
  });
  /** Returns nothing if the decoder throws because it finds no code. */
  const orNothing = (/** @type {() => string} */ decode) => {
    try {
      return decode();
    } catch {
      return undefined;
    }
  };
  const named = (/** @type {string} */ name) =>
    `${name} ${JSON.parse(readFileSync(`${peers}/node_modules/${name}/package.json`, 'utf8')).version} (npm)`;
  return {
    [named('jsqr')]: (p) => (jsqr.default ?? jsqr)(p.rgba, p.width, p.height)?.data,
    [named('@zxing/library')]: (p) =>
      orNothing(() => {
        const source = new zxing.RGBLuminanceSource(new Uint8ClampedArray(p.grey), p.width, p.height);
        const bitmap = new zxing.BinaryBitmap(new zxing.HybridBinarizer(source));
        return new zxing.QRCodeReader().decode(bitmap, new Map([[zxing.DecodeHintType.TRY_HARDER, true]])).getText();
      }),
    [named('zxing-wasm')]: async (p) =>
      (
        await zxingWasm.readBarcodes(
          { data: p.rgba, width: p.width, height: p.height },
          { formats: ['QRCode'], tryHarder: true },
        )
      ).find((/** @type {{ isValid: boolean }} */ found) => found.isValid)?.text,
    [named('qr')]: (p) => orNothing(() => qr.default({ width: p.width, height: p.height, data: p.rgba })),
    [named('@undecaf/zbar-wasm')]: async (p) =>
      (await zbar.scanGrayBuffer(p.grey.buffer, p.width, p.height))
        .find((/** @type {{ typeName: string }} */ found) => found.typeName === 'ZBAR_QRCODE')
        ?.decode(),
  };
}
