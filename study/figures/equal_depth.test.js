// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { oftener, readsOf, readsOverModels, spreadOf } from './equal_depth.js';

/** @param {string} method @param {number[]} reads */
const rowsOf = (method, reads) => reads.map((printed, at) => ({ model: 'plate', method, text: at + 1, printed }));

test('methods are compared by the median over texts', () => {
  const rows = [...rowsOf('ours-whole-modules', [40, 44, 30, 41]), ...rowsOf('a', [60, 39, 38, 41]), ...rowsOf('b', [41, 41, 41, 42])];
  assert.equal(readsOf(rows, 'ours-whole-modules'), 40.5);
  assert.deepEqual(oftener(rows), ['b']);
  assert.equal(spreadOf(rows), 14);
});

test('a model without rows of a method does not count for it', () => {
  const star = { model: 'star', method: 'a', text: 1, printed: 9 };
  assert.equal(readsOverModels([...rowsOf('a', [50, 51, 52]), ...rowsOf('b', [7])], 'a'), 51);
  assert.equal(readsOverModels([...rowsOf('b', [7, 8, 9]), star], 'b'), 8);
});
