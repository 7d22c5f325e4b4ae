// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { inflateSync } from 'node:zlib';
import { drawIcon, readIcon } from './app_icon.js';
import { writePng } from './png.js';

const icon = readIcon(readFileSync(new URL('../../public/favicon.svg', import.meta.url), 'utf8'));
const kGround = [15, 107, 92, 255];
const kInk = [255, 255, 255, 255];

/** @param {Uint8Array} rgba @param {number} pixels @param {number} x @param {number} y */
const pixel = (rgba, pixels, x, y) => [...rgba.subarray(4 * (y * pixels + x), 4 * (y * pixels + x) + 4)];

test('the icon has the colours of its drawing', () => {
  const rgba = drawIcon(icon, 64); // two pixels per unit
  assert.deepEqual(pixel(rgba, 64, 0, 0), [0, 0, 0, 0]); // outside the rounded corner
  assert.deepEqual(pixel(rgba, 64, 32, 4), kGround);
  assert.deepEqual(pixel(rgba, 64, 14, 14), kInk); // in the ring of the upper left finder pattern
  assert.deepEqual(pixel(rgba, 64, 20, 20), kGround); // in the gap within the ring
  assert.deepEqual(pixel(rgba, 64, 36, 36), kInk); // a module
  assert.deepEqual(pixel(rgba, 64, 42, 36), kGround); // next to the module
});

test('the maskable icon fills the square and draws within its middle 80 %', () => {
  const rgba = drawIcon(icon, 100, { maskable: true });
  assert.deepEqual(pixel(rgba, 100, 0, 0), kGround);
  for (let y = 0; y < 100; y += 1) {
    for (let x = 0; x < 100; x += 1) {
      if (Math.hypot(x - 49.5, y - 49.5) > 40) assert.deepEqual(pixel(rgba, 100, x, y), kGround, `${x}, ${y}`);
    }
  }
});

test('a PNG file holds the pixels it was given, row by row', () => {
  const rgba = Uint8Array.from({ length: 4 * 3 * 2 }, (_, i) => i * 7);
  const png = writePng(3, 2, rgba);
  const data = png.indexOf('IDAT');
  const rows = inflateSync(png.subarray(data + 4, data + 4 + png.readUInt32BE(data - 4)));
  assert.deepEqual([...rows], [0, ...rgba.subarray(0, 12), 0, ...rgba.subarray(12)]);
  assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], [3, 2]);
});

test('an icon with curves is refused, naming the path command', () => {
  assert.throws(
    () =>
      readIcon(
        '<svg viewBox="0 0 8 8"><rect rx="1" fill="#000"/><g fill="#fff"><path d="M1 1c1 1 1 1 1 1z"/></g></svg>',
      ),
    /command "c"/,
  );
});
