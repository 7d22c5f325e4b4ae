// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { shrunkTo } from '../reader/variants.js';
import { distanceMm, safeTiltDeg } from './view_trials.js';

test('A code is safe up to the last tilt before the first direction that fails', () => {
  const tilts = (/** @type {number[]} */ ...reads) => reads.map((count, i) => ({ tiltDeg: 15 * (i + 1), reads: count, all: 4 }));
  assert.equal(safeTiltDeg(tilts(4, 4, 4)), 45);
  assert.equal(safeTiltDeg(tilts(4, 4, 3)), 30);
  assert.equal(safeTiltDeg(tilts(4, 2, 4)), 15);
  assert.equal(safeTiltDeg(tilts(3, 4, 4)), 0);
});

test('A phone’s video of 1920 pixels across 65° sees a module of 1 mm with 3 pixels from half a metre away', () => {
  assert.ok(Math.abs(distanceMm(1, 3) - 502.3) < 0.1, String(distanceMm(1, 3)));
  assert.equal(distanceMm(2, 3), 2 * distanceMm(1, 3));
});

test('A picture shrunk to a width keeps its mean, and that of each half', () => {
  const image = { width: 7, height: 7, pixels: Uint8Array.from({ length: 49 }, (_, i) => (i % 7 < 3 ? 0 : i % 7 === 3 ? 100 : 200)) };
  const small = shrunkTo(image, 2);
  assert.deepEqual([small.width, small.height], [2, 2]);
  assert.deepEqual([...small.pixels], [14, 186, 14, 186]);  // (0·3 + 100/2)/3.5 and (100/2 + 200·3)/3.5
});
