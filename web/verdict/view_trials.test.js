// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { shrunkTo } from '../decoder/variants.js';
import { distanceMm, kTrials, safeTiltDeg, tryViews } from './view_trials.js';

test('A code is safe up to the last tilt before the first direction that fails', () => {
  const tilts = (/** @type {number[]} */ ...reads) => reads.map((count, i) => ({ tiltDeg: 15 * (i + 1), reads: count, all: 4 }));
  assert.equal(safeTiltDeg(tilts(4, 4, 4)), 45);
  assert.equal(safeTiltDeg(tilts(4, 4, 3)), 30);
  assert.equal(safeTiltDeg(tilts(4, 2, 4)), 15);
  assert.equal(safeTiltDeg(tilts(3, 4, 4)), 0);
});

test('It is looked from farther and farther aside until nothing is read, and the progress ends at its end', async () => {
  /** @type {number[]} */ const done = [];
  /** @type {[number, number][]} */ const asked = [];
  const image = (/** @type {number} */ grey) => ({ width: 400, height: 400, pixels: new Uint8Array(160_000).fill(grey) });
  const trials = await tryViews({
    pictureFrom: async (tiltDeg, azimuthDeg) => {
      asked.push([tiltDeg, azimuthDeg]);
      return image(tiltDeg < 10 || (tiltDeg === 10 && azimuthDeg < 180) ? 1 : 0);  // 1: to be read
    },
    picture: async () => image(1),
    reads: async ({ pixels, width }) => pixels[0] === 1 && width > 150,
    modules: 29,
    onTrial: (count) => done.push(count),
    signal: new AbortController().signal,
  });
  assert.deepEqual(trials?.tilts, [
    { tiltDeg: 5, reads: 4, all: 4 }, { tiltDeg: 10, reads: 2, all: 4 }, { tiltDeg: 15, reads: 0, all: 4 },
  ]);
  assert.equal(asked.length, 12);
  assert.equal(safeTiltDeg(trials.tilts), 5);
  assert.equal(trials.leastPixels, 4);  // of a module: 4 · 41 pixels are more than 150, and 3.3 · 41 are not
  assert.equal(done.at(-1), kTrials);
  assert.ok(done.every((count, i) => i === 0 || count > done[i - 1]));
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
