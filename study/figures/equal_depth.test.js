// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { oftener, readsOf, spreadOf } from './equal_depth.js';

/** @param {string} method @param {number[]} reads */
const rowsOf = (method, reads) => reads.map((printed, at) => ({ model: 'plate', method, text: at + 1, printed }));

test('methods are compared by the median over texts', () => {
  const rows = [...rowsOf('ours-whole-modules', [40, 44, 30, 41]), ...rowsOf('a', [60, 39, 38, 41]), ...rowsOf('b', [41, 41, 41, 42])];
  assert.equal(readsOf(rows, 'ours-whole-modules'), 40.5);
  assert.deepEqual(oftener(rows), ['b']);
  assert.equal(spreadOf(rows), 14);
});
