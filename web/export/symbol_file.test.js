// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { symbolPixels, symbolSvg } from './symbol_file.js';

const kRows = ['101', '011', '110'];

/** Returns the dark modules of a picture by filling the rectangles of its path. @param {string} svg */
function drawn(svg) {
  const [, edge] = /viewBox="0 0 (\d+) /.exec(svg) ?? [];
  const grid = Array.from({ length: Number(edge) }, () => Array(Number(edge)).fill('0'));
  const path = /<path d="([^"]*)"/.exec(svg)?.[1] ?? '';
  for (const [, x, y, length] of path.matchAll(/M(\d+) (\d+)h(\d+)v1h-\3z/g)) {
    for (let i = 0; i < Number(length); i += 1) grid[Number(y)][Number(x) + i] = '1';
  }
  return grid.map((row) => row.join(''));
}

const kWithQuietZone = [
  ...Array(4).fill('0'.repeat(11)),
  ...kRows.map((row) => `0000${row}0000`),
  ...Array(4).fill('0'.repeat(11)),
];

test('the SVG shows every module and a quiet zone of four', () => {
  assert.deepEqual(drawn(symbolSvg(kRows, { title: 'x' })), kWithQuietZone);
});

test('the SVG has the size of the symbol plus the quiet zone', () => {
  assert.match(symbolSvg(kRows, { title: 'x', sizeMm: 30 }), / width="110mm" height="110mm" viewBox="0 0 11 11"/);
  assert.doesNotMatch(symbolSvg(kRows, { title: 'x' }), / width=/);
});

test('the title of the SVG is escaped', () => {
  const svg = symbolSvg(kRows, { title: '</title><script>"&\u0000' });
  assert.ok(svg.includes('<title>&#60;/title&#62;&#60;script&#62;&#34;&#38;\ufffd</title>'));
});

test('the PNG has whole pixels per module, black on white', () => {
  const { edge, pixels } = symbolPixels(kRows);
  assert.ok(edge >= 1024 && edge % 11 === 0);
  const scale = edge / 11;
  for (let y = 0; y < edge; y += 1) {
    for (let x = 0; x < edge; x += 1) {
      const dark = kWithQuietZone[Math.floor(y / scale)][Math.floor(x / scale)] === '1';
      const at = 4 * (y * edge + x);
      if (pixels[at] !== (dark ? 0 : 255) || pixels[at + 3] !== 255) assert.fail(`pixel ${x}, ${y}`);
    }
  }
});
