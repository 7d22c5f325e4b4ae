// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { heightLines } from './height_mark.js';

test('The dimension line has a stroke across each end', () => {
  assert.deepEqual(heightLines({ foot: [50, 200], top: [50, 100], heightMm: 8 }), [
    [50, 200, 50, 100],
    [46, 200, 54, 200],
    [46, 100, 54, 100],
  ]);
});

test('There is no line where it would be too short to see', () => {
  assert.equal(heightLines({ foot: [50, 200], top: [60, 190], heightMm: 8 }), null);
});
