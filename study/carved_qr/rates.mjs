// SPDX-License-Identifier: GPL-3.0-or-later
// How many pictures of CarvedQR the decoders of npm and Debian read.
//
//     node rates.mjs FOLDER PEERS [--out FILE.csv]    PEERS: the folder in which the npm packages are installed
//
// A row for each decoder, surface, light and tilt: pictures, how many gave the code's text, how many another one. Each
// decoder gets the picture as it is, once, with its own thorough settings and no others.
import { execFileSync, spawnSync } from 'node:child_process';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const [folder, peers] = process.argv.slice(2);
const outAt = process.argv.indexOf('--out');
const require = createRequire(`${peers}/package.json`);
const imported = (/** @type {string} */ name) => import(pathToFileURL(require.resolve(name)).href);

/** @typedef {{ width: number, height: number, grey: Uint8Array, rgba: Uint8ClampedArray }} Picture */

/** @returns {Picture} */
function readPicture(/** @type {string} */ file) {
  const { width, height, data } = require('pngjs').PNG.sync.read(readFileSync(file));
  const grey = new Uint8Array(width * height);
  for (let i = 0; i < grey.length; i += 1) grey[i] = data[4 * i];
  return { width, height, grey, rgba: new Uint8ClampedArray(data) };
}

/** Decoders of npm: from a picture to its text, or nothing. */
async function npmDecoders() {
  const jsqr = require('jsqr');
  const zxing = require('@zxing/library');
  const zxingWasm = await imported('zxing-wasm/reader');
  zxingWasm.prepareZXingModule({
    overrides: { wasmBinary: readFileSync(`${peers}/node_modules/zxing-wasm/dist/reader/zxing_reader.wasm`).buffer },
  });
  const qr = await imported('qr/decode.js');
  const zbar = await imported('@undecaf/zbar-wasm');
  const version = (/** @type {string} */ name) => JSON.parse(readFileSync(`${peers}/node_modules/${name}/package.json`, 'utf8')).version;
  return {
    [`jsqr ${version('jsqr')} (npm)`]: (p) => (jsqr.default ?? jsqr)(p.rgba, p.width, p.height)?.data,
    [`@zxing/library ${version('@zxing/library')} (npm)`]: (p) => {
      const source = new zxing.RGBLuminanceSource(new Uint8ClampedArray(p.grey), p.width, p.height);
      const hints = new Map([[zxing.DecodeHintType.TRY_HARDER, true]]);
      try {
        return new zxing.QRCodeReader().decode(new zxing.BinaryBitmap(new zxing.HybridBinarizer(source)), hints).getText();
      } catch {
        return undefined;
      }
    },
    [`zxing-wasm ${version('zxing-wasm')} (npm)`]: async (p) =>
      (await zxingWasm.readBarcodes({ data: p.rgba, width: p.width, height: p.height }, { formats: ['QRCode'], tryHarder: true }))
        .find((found) => found.isValid)?.text,
    [`qr ${version('qr')} (npm)`]: (p) => {
      try {
        return qr.default({ width: p.width, height: p.height, data: p.rgba });
      } catch {
        return undefined;
      }
    },
    [`@undecaf/zbar-wasm ${version('@undecaf/zbar-wasm')} (npm)`]: async (p) =>
      (await zbar.scanGrayBuffer(p.grey.buffer, p.width, p.height)).find((found) => found.typeName === 'ZBAR_QRCODE')?.decode(),
  };
}

const debianVersion = (/** @type {string} */ name) =>
  execFileSync('dpkg-query', ['--show', '--showformat=${Version}', name], { encoding: 'utf8' }).split(/[+-]/)[0];

/** Decoders of Debian: from files to texts by file. */
const debianDecoders = {
  [`zbarimg ${debianVersion('zbar-tools')} (Debian)`]: (files) => {
    const out = spawnSync('zbarimg', ['--quiet', '--xml', '-Sdisable', '-Sqrcode.enable', ...files], { encoding: 'utf8', maxBuffer: 1e9 }).stdout;
    const texts = new Map();
    for (const [, file, body] of out.matchAll(/<source href='([^']*)'>(.*?)<\/source>/gs)) {
      texts.set(file, /<data><!\[CDATA\[(.*?)\]\]>/s.exec(body)?.[1]);
    }
    return texts;
  },
  // Debian's OpenCV is built without its QR decoder.
  [`ZXingReader ${debianVersion('zxing-cpp-tools')} (Debian)`]: (files) => {
    const out = spawnSync('ZXingReader', ['-1', '-format', 'QRCode', ...files], { encoding: 'utf8', maxBuffer: 1e9 }).stdout;
    const texts = new Map();
    for (const [, file, text] of out.matchAll(/^(\S+) QRCode "(.*)"$/gm)) texts.set(file, text);
    return texts;
  },
};

const truth = readdirSync(`${folder}/truth`).sort().flatMap((part) =>
  readFileSync(`${folder}/truth/${part}`, 'utf8').split('\n').filter(Boolean).map((line) => JSON.parse(line)));
const kTilts = [[0, '0'], [20, 'up to 20'], [45, 'up to 45']];
const classOf = (line) => [line.surface, line.lamp ? 'sky and lamp' : 'sky', kTilts.find(([most]) => line.tiltDeg <= most)[1]];

const rows = new Map();
function count(/** @type {string} */ decoder, line, text) {
  const key = [decoder, ...classOf(line)].join(',');
  const row = rows.get(key) ?? { pictures: 0, read: 0, wrong: 0 };
  row.pictures += 1;
  row.read += Number(text === line.text);
  row.wrong += Number(Boolean(text) && text !== line.text);
  rows.set(key, row);
}

for (const [name, decode] of Object.entries(await npmDecoders())) {
  for (const line of truth) count(name, line, await decode(readPicture(`${folder}/pictures/${line.picture}`)));
  console.error(`${name}: ${truth.length} pictures`);
}
for (const [name, decode] of Object.entries(debianDecoders)) {
  const texts = decode(truth.map((line) => `${folder}/pictures/${line.picture}`));
  for (const line of truth) count(name, line, texts.get(`${folder}/pictures/${line.picture}`));
  console.error(`${name}: ${truth.length} pictures`);
}
const csv = ['decoder,surface,light,tilt_deg,pictures,read,wrong',
  ...[...rows].sort(([a], [b]) => (a < b ? -1 : 1)).map(([key, r]) => `${key},${r.pictures},${r.read},${r.wrong}`)].join('\n');
if (outAt > 0) writeFileSync(process.argv[outAt + 1], `${csv}\n`);
else console.log(csv);
