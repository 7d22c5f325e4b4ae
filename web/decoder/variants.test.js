// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { blurred, readingVariants, shrunk, stretched } from './variants.js';

test('Stretching takes the darkest to black and the lightest to white', () => {
  assert.deepEqual([...stretched({ width: 3, height: 1, pixels: Uint8Array.of(100, 125, 150) }).pixels], [0, 128, 255]);
});

test('A picture of one grey stays finite when it is stretched', () => {
  assert.deepEqual([...stretched({ width: 2, height: 1, pixels: Uint8Array.of(7, 7) }).pixels], [0, 0]);
});

test('Shrinking takes means and drops an incomplete last row and column', () => {
  const picture = { width: 3, height: 3, pixels: Uint8Array.of(0, 10, 99, 20, 30, 99, 99, 99, 99) };
  assert.deepEqual(shrunk(picture, 2), { width: 1, height: 1, pixels: Uint8Array.of(15) });
});

test('A blur keeps an even grey, borders included, and spreads a point by the Gaussian', () => {
  const even = { width: 9, height: 9, pixels: new Uint8Array(81).fill(200) };
  assert.deepEqual(blurred(even, 1.5).pixels, even.pixels);
  const point = { width: 9, height: 9, pixels: new Uint8Array(81) };
  point.pixels[40] = 255;
  const { pixels } = blurred(point, 1);
  assert.equal(pixels[40], Math.round(255 / (2 * Math.PI)));  // the sum over ±3 of the kernel is 0.9999 √(2π)
  assert.equal(pixels[41], Math.round((255 / (2 * Math.PI)) * Math.exp(-0.5)));
  assert.equal(pixels[31], pixels[41]);
});

test('There are six variants, the picture itself first', () => {
  const picture = { width: 12, height: 12, pixels: new Uint8Array(144).fill(9) };
  const variants = readingVariants(picture, 4);
  assert.equal(variants[0], picture);
  assert.deepEqual(variants.map(({ width }) => width), [12, 12, 12, 12, 6, 4]);
});
