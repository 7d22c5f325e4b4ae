// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { paintDepths, paintHeights, paintLight, paintNormals, rampColour } from './map_colours.js';

/** @param {import('./map_colours.js').Pixels} pixels @param {number} x @param {number} y */
const pixel = ({ width, rgba }, x, y) => [...rgba.subarray(4 * (y * width + x), 4 * (y * width + x) + 4)];

test('the ramp starts and ends with its first and last colour and is linear between two', () => {
  assert.deepEqual(rampColour(0), [68, 1, 84]);
  assert.deepEqual(rampColour(1), [253, 231, 37]);
  assert.deepEqual(rampColour(2), [253, 231, 37]);
  assert.deepEqual(rampColour(0.125), [63, 41.5, 111.5]);
});

test('the first row of a map is the last of the picture', () => {
  const pixels = paintLight({ width: 1, height: 2, components: 1, values: Float32Array.of(0, 1) });
  assert.deepEqual(pixel(pixels, 0, 0), [255, 255, 255, 255]);
  assert.deepEqual(pixel(pixels, 0, 1), [0, 0, 0, 255]);
});

test('outside the model a map is transparent, and its heights do not count', () => {
  const surface = { width: 3, height: 1, components: 4, values: Float32Array.of(0, 0, 1, 2, 0, 0, 0, -50, 0, 0, 1, 4) };
  const heights = paintHeights(surface);
  assert.deepEqual([heights.from, heights.to], [2, 4]);
  assert.deepEqual(pixel(heights, 0, 0), [68, 1, 84, 255]);
  assert.deepEqual(pixel(heights, 1, 0), [0, 0, 0, 0]);
  assert.deepEqual(pixel(paintNormals(surface), 2, 0), [128, 128, 255, 255]);
});

test('uncarved submodules are transparent', () => {
  const depths = paintDepths({ width: 2, height: 1, components: 1, values: Float32Array.of(0, 0.5) });
  assert.equal(pixel(depths, 0, 0)[3], 0);
  assert.equal(pixel(depths, 1, 0)[3], 255);
  assert.deepEqual([depths.from, depths.to], [0.5, 0.5]);
});
