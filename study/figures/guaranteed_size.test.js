// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gainByDepth, gainsAtPlaces, optimalIsLargest } from './guaranteed_size.js';

const sizes = (/** @type {Record<string, number>} */ byDirection) =>
  Object.entries(byDirection).map(([direction, mm]) => ({ direction, guaranteed_mm: mm }));

test('what depth adds is a fraction of the size by normals alone', () => {
  assert.equal(gainByDepth(sizes({ 'mean-normal': 40, 'depth-balanced': 50 })), 0.25);
  assert.equal(gainByDepth(sizes({ 'mean-normal': 40 })), undefined);
});

test('gains are counted at every place where both directions have a code', () => {
  const at = (/** @type {number} */ place, /** @type {Record<string, number>} */ byDirection) =>
    sizes(byDirection).map((row) => ({ ...row, model: 'vase', place }));
  const rows = [
    ...at(1, { 'mean-normal': 40, 'depth-balanced': 50 }),
    ...at(2, { 'mean-normal': 40, 'depth-balanced': 30 }),
    ...at(3, { 'depth-balanced': 30 }),
  ];
  assert.deepEqual(gainsAtPlaces(rows), [0.25, -0.25]);
});

test('the best direction may share the largest size', () => {
  assert.equal(optimalIsLargest(sizes({ pca: 40, optimal: 40 })), true);
  assert.equal(optimalIsLargest(sizes({ pca: 40, optimal: 39 })), false);
  assert.equal(optimalIsLargest(sizes({ pca: 40 })), undefined);
});
