// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gainByDepth, optimalIsLargest } from './guaranteed_size.js';

const sizes = (/** @type {Record<string, number>} */ byDirection) =>
  Object.entries(byDirection).map(([direction, mm]) => ({ direction, guaranteed_mm: mm }));

test('what depth adds is a fraction of the size by normals alone', () => {
  assert.equal(gainByDepth(sizes({ 'mean-normal': 40, 'depth-balanced': 50 })), 0.25);
  assert.equal(gainByDepth(sizes({ 'mean-normal': 40 })), undefined);
});

test('the best direction may share the largest size', () => {
  assert.equal(optimalIsLargest(sizes({ pca: 40, optimal: 40 })), true);
  assert.equal(optimalIsLargest(sizes({ pca: 40, optimal: 39 })), false);
  assert.equal(optimalIsLargest(sizes({ pca: 40 })), undefined);
});
