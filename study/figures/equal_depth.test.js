// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { oftener, readsOf, readsOverModels, spreadOf, wholeModels } from './equal_depth.js';

/** @param {string} method @param {number[]} reads */
const rowsOf = (method, reads) => reads.map((printed, at) => ({ model: 'plate', method, text: at + 1, printed }));

test('methods are compared by the median over texts', () => {
  const rows = [
    ...rowsOf('ours', [40, 44, 30, 41]),
    ...rowsOf('a', [60, 39, 38, 41]),
    ...rowsOf('b', [41, 41, 41, 42]),
  ];
  assert.equal(readsOf(rows, 'ours'), 40.5);
  assert.deepEqual(oftener(rows), ['b']);
  assert.equal(spreadOf(rows), 14);
});

test('models that lack a row are not compared', () => {
  const whole = [...rowsOf('a', [1, 2]), ...rowsOf('ours', [3, 4])];
  const lacks = rowsOf('a', [1, 2]).map((row) => ({ ...row, model: 'star' }));
  assert.deepEqual(wholeModels([...whole, ...lacks]), [whole]);
  assert.deepEqual(wholeModels([...whole, ...lacks, { model: 'star', method: 'ours', text: 1, printed: 3 }]), [whole]);
  assert.deepEqual(wholeModels(rowsOf('a', [1, 2])), []);
});

test('a model without rows of a method does not count for it', () => {
  const star = { model: 'star', method: 'a', text: 1, printed: 9 };
  assert.equal(readsOverModels([...rowsOf('a', [50, 51, 52]), ...rowsOf('b', [7])], 'a'), 51);
  assert.equal(readsOverModels([...rowsOf('b', [7, 8, 9]), star], 'b'), 8);
});
