// SPDX-License-Identifier: GPL-3.0-or-later
// Which decoders read which character sets? Prints the tables of docs/decisions/0049.
//   node bench/character_sets.mjs qrelief_character_sets PEERS   (PEERS: script/decoders)
// Also asks zbarimg and OpenCV's WeChat detector (python3-opencv) where they are installed.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { npmDecoders, pictureOf } from '../study/decoders.mjs';

const [program, peers] = process.argv.slice(2);
const folder = mkdtempSync('/tmp/character-sets-');
const symbols = execFileSync(program, [folder], { encoding: 'utf8' })
  .trim()
  .split('\n')
  .map(
    (line) =>
      /** @type {{ text: string, way: string, version: number, files: string[], zxing: string[] }} */ (
        JSON.parse(line)
      ),
  );

const readPgm = (/** @type {string} */ file) => {
  const bytes = readFileSync(file);
  const [header, width, height] = /^P5\n(\d+) (\d+)\n255\n/.exec(bytes.toString('latin1', 0, 30)) ?? [''];
  return pictureOf(new Uint8Array(bytes.subarray(header.length)), Number(width), Number(height));
};

const kWeChat = `
import cv2, json, sys
detector = cv2.wechat_qrcode_WeChatQRCode()
def text(picture):
    try: return ''.join(detector.detectAndDecode(picture)[0])
    except (UnicodeDecodeError, SystemError): return ''  # bytes that are not UTF-8
print(json.dumps([[text(cv2.imread(file)) for file in files] for files in json.load(sys.stdin)]))`;

/** Runs a program that may be missing or find nothing. */
const output = (/** @type {string} */ name, /** @type {string[]} */ given, input = '') => {
  try {
    return execFileSync(name, given, { input, encoding: 'utf8', stdio: ['pipe', 'pipe', 'ignore'] });
  } catch {
    return '';
  }
};

/** Returns the first text of a symbol's pictures: a decoder may miss a symbol of one size. */
const firstOf = (/** @type {(string | undefined)[]} */ texts) => texts.find((text) => text) ?? '';

/** @type {Record<string, string[]>} */ const reads = {
  'ZXing-C++ 1.4 (Debian)': symbols.map(({ zxing }) => firstOf(zxing)),
};
for (const [name, decode] of Object.entries(await npmDecoders(peers))) {
  reads[name] = [];
  for (const { files } of symbols) {
    const texts = [];
    for (const file of files) texts.push(await decode(readPgm(file)));
    reads[name].push(firstOf(texts));
  }
}
const version = output('zbarimg', ['--version']).trim();
if (version) {
  const given = ['--raw', '-q', '--oneshot', '-Sbinary=0'];
  reads[`zbarimg ${version} (Debian)`] = symbols.map(({ files }) =>
    firstOf(files.map((file) => output('zbarimg', [...given, file]).replace(/\n$/, ''))),
  );
}
const weChat = output('/usr/bin/python3', ['-c', kWeChat], JSON.stringify(symbols.map(({ files }) => files)));
if (weChat) reads['WeChat in OpenCV 4.6 (Debian)'] = /** @type {string[][]} */ (JSON.parse(weChat)).map(firstOf);
rmSync(folder, { recursive: true });

const ways = [...new Set(symbols.map(({ way }) => way))];
const plain = (/** @type {string} */ text) => text.replace(/\r\n/g, '\n').replace(/^\uFEFF/, '');
const isRight = (/** @type {string} */ name, /** @type {number} */ i) =>
  plain(reads[name][i]) === plain(symbols[i].text);
const row = (/** @type {(string | number)[]} */ cells) => console.log(`| ${cells.join(' | ')} |`);

row(['decoder', ...ways]);
row(['---', ...ways.map(() => '---')]);
for (const name of Object.keys(reads)) {
  row([
    name,
    ...ways.map((way) => {
      const these = [...symbols.keys()].filter((i) => symbols[i].way === way);
      return `${these.filter((i) => isRight(name, i)).length} of ${these.length}`;
    }),
  ]);
}
console.log();
const texts = [...new Set(symbols.map(({ text }) => text))];
row(['text', ...ways]);
row(['---', ...ways.map(() => '---')]);
for (const text of texts) {
  const cells = ways.map((way) => {
    const i = symbols.findIndex((symbol) => symbol.text === text && symbol.way === way);
    const wrong = i < 0 ? [] : Object.keys(reads).filter((name) => !isRight(name, i));
    if (process.env.QRELIEF_READS && i >= 0)
      for (const name of wrong) console.error(way, name, JSON.stringify(text), '->', JSON.stringify(reads[name][i]));
    return i < 0 ? '–' : `${Object.keys(reads).length - wrong.length}, version ${symbols[i].version}`;
  });
  row([text.length > 40 ? `${text.slice(0, 12).replace(/\s+/g, ' ')}…` : text, ...cells]);
}
