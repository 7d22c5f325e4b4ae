// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bearsHigher, lowerNeverHurts, readRuns, tolerates } from './light_angles.js';

const rows = (/** @type {Record<number, number>} */ reads) =>
  Object.entries(reads).map(([at, count]) => ({ read_at: Number(at), reads: count }));

test('angles that read are those with 29 of 72 tries, in runs of neighbours', () => {
  assert.deepEqual(readRuns(rows({ 33: 40, 23: 30, 15: 28, 8: 29, 88: 0 })), [[8], [23, 33]]);
  assert.deepEqual(readRuns(rows({ 8: 28 })), []);
});

test('a tolerance needs every angle from the lamp’s own up to it', () => {
  assert.equal(tolerates(rows({ 4: 0, 8: 30, 15: 30, 23: 29, 33: 0 }), 8, 15), true);
  assert.equal(tolerates(rows({ 8: 30, 15: 10, 23: 29 }), 8, 15), false);
  assert.equal(tolerates(rows({ 8: 10, 15: 30, 23: 29 }), 8, 15), false);
  assert.equal(tolerates([], 8, 15), false);
});

test('a code bears lamps up to the last one from its own on', () => {
  assert.equal(bearsHigher(rows({ 4: 0, 8: 30, 15: 30, 23: 10, 33: 50 }), 8), 7);
  assert.equal(bearsHigher(rows({ 8: 10, 15: 30 }), 8), -1);
});

test('a lower lamp hurts if one of them keeps the code from being read', () => {
  assert.equal(lowerNeverHurts(rows({ 4: 30, 8: 40, 33: 0 }), 33), true);
  assert.equal(lowerNeverHurts(rows({ 4: 20, 8: 40, 33: 60 }), 33), false);
});
