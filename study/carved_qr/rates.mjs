// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the pictures of CarvedQR that the decoders of npm and Debian decode.
//
//     node rates.mjs FOLDER PEERS [--out FILE.csv]    PEERS: the folder in which the npm packages are installed
//
// Writes a row for each decoder, surface, light and tilt: number of pictures, of right texts, and of wrong ones. Each
// decoder gets the unchanged picture, once, with its own thorough settings only.
import { execFileSync, spawnSync } from 'node:child_process';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { npmDecoders, readPicture } from '../decoders.mjs';

const [folder, peers] = process.argv.slice(2);
const outAt = process.argv.indexOf('--out');
const debianVersion = (/** @type {string} */ name) =>
  execFileSync('dpkg-query', ['--show', '--showformat=${Version}', name], { encoding: 'utf8' }).split(/[+-]/)[0];

/** Debian's decoders, each a function from files to texts by file. */
const debianDecoders = {
  [`zbarimg ${debianVersion('zbar-tools')} (Debian)`]: (files) => {
    const out = spawnSync('zbarimg', ['--quiet', '--xml', '-Sdisable', '-Sqrcode.enable', ...files], {
      encoding: 'utf8',
      maxBuffer: 1e9,
    }).stdout;
    const texts = new Map();
    for (const [, file, body] of out.matchAll(/<source href='([^']*)'>(.*?)<\/source>/gs)) {
      texts.set(file, /<data><!\[CDATA\[(.*?)\]\]>/s.exec(body)?.[1]);
    }
    return texts;
  },
  // Debian's OpenCV is built without its QR decoder.
  [`ZXingReader ${debianVersion('zxing-cpp-tools')} (Debian)`]: (files) => {
    const out = spawnSync('ZXingReader', ['-1', '-format', 'QRCode', ...files], {
      encoding: 'utf8',
      maxBuffer: 1e9,
    }).stdout;
    const texts = new Map();
    for (const [, file, text] of out.matchAll(/^(\S+) QRCode "(.*)"$/gm)) texts.set(file, text);
    return texts;
  },
};

const truth = readdirSync(`${folder}/truth`)
  .sort()
  .flatMap((part) =>
    readFileSync(`${folder}/truth/${part}`, 'utf8')
      .split('\n')
      .filter(Boolean)
      .map((line) => JSON.parse(line)),
  );
const kTilts = [
  [0, '0'],
  [20, 'up to 20'],
  [45, 'up to 45'],
];
const classOf = (line) => [
  line.surface,
  line.lamp ? 'sky and lamp' : 'sky',
  kTilts.find(([most]) => line.tiltDeg <= most)[1],
];

const rows = new Map();
function count(/** @type {string} */ decoder, line, text) {
  const key = [decoder, ...classOf(line)].join(',');
  const row = rows.get(key) ?? { pictures: 0, read: 0, wrong: 0 };
  row.pictures += 1;
  row.read += Number(text === line.text);
  row.wrong += Number(Boolean(text) && text !== line.text);
  rows.set(key, row);
}

for (const [name, decode] of Object.entries(await npmDecoders(peers))) {
  for (const line of truth) count(name, line, await decode(readPicture(peers, `${folder}/pictures/${line.picture}`)));
  console.error(`${name}: ${truth.length} pictures`);
}
for (const [name, decode] of Object.entries(debianDecoders)) {
  const texts = decode(truth.map((line) => `${folder}/pictures/${line.picture}`));
  for (const line of truth) count(name, line, texts.get(`${folder}/pictures/${line.picture}`));
  console.error(`${name}: ${truth.length} pictures`);
}
const csv = [
  'decoder,surface,light,tilt_deg,pictures,read,wrong',
  ...[...rows].sort(([a], [b]) => (a < b ? -1 : 1)).map(([key, r]) => `${key},${r.pictures},${r.read},${r.wrong}`),
].join('\n');
if (outAt > 0) writeFileSync(process.argv[outAt + 1], `${csv}\n`);
else console.log(csv);
