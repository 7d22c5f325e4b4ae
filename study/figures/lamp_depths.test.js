// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { lampsDeepen, lampsMakeShallower } from './lamp_depths.js';

const rows = (/** @type {number[]} */ ...depths) =>
  depths.map((mm, lamps) => ({ modules: 'none', lamps, depth_mm: mm }));

test('every lamp counts, and one that is missing decides nothing', () => {
  assert.equal(lampsDeepen(rows(0.3, 0.4, 0.5), 'none'), true);
  assert.equal(lampsDeepen(rows(0.3, 0.5, 0.4), 'none'), false);
  assert.equal(lampsMakeShallower(rows(0.5, 0.4, 0.3), 'none'), true);
  assert.equal(lampsMakeShallower(rows(0.5, 0.4, 0.4), 'none'), false);
  assert.equal(lampsDeepen(rows(0.3, 0.4), 'none'), undefined);
  assert.equal(lampsDeepen(rows(0.3, 0.4, 0.5), 'square'), undefined);
});
