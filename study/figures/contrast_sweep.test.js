// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { contrastSweep, contrastThatReaches, contrastsOfPaperOrder } from './contrast_sweep.js';

const row = (/** @type {string} */ modules, /** @type {number} */ contrast, /** @type {number} */ depth) => ({
  model: 'plate',
  modules,
  contrast,
  depth_mm: depth,
});
const kRows = [
  row('none', 0.3, 0.8),
  row('none', 0.6, 1.2),
  row('square', 0.3, 0.3),
  row('square', 0.6, 0.6),
  row('diamond', 0.3, 0.5),
  row('diamond', 0.6, 0.9),
];

test('the least contrast that is deep enough counts', () => {
  assert.equal(contrastThatReaches(kRows, 'none', 1.1), 0.6);
  assert.equal(contrastThatReaches(kRows, 'none', 1.3), undefined);
  assert.equal(contrastThatReaches(kRows, 'none', undefined), undefined);
});

test('the paper’s order needs every pattern between the methods of Peng; whole modules do not count', () => {
  assert.deepEqual(contrastsOfPaperOrder(kRows, 0.4, 1.1), [0.6]);
  assert.deepEqual(contrastsOfPaperOrder(kRows, 0.2, 1.1), [0.3, 0.6]);
  assert.deepEqual(contrastsOfPaperOrder(kRows, undefined, 1.1), []);
});

test('where a method was not measured, nothing is said of it', () => {
  const comparison = [{ model: 'plate', method: 'self-shadow-2019', depth_mm: 1.1 }];
  const say = (/** @type {any[]} */ method_comparison) =>
    contrastSweep.find(kRows, { method_comparison }).map((one) => one.say);
  assert.deepEqual(say(comparison), ['sweepReaches', 'sweepWhy']);
  assert.deepEqual(say([...comparison, { model: 'plate', method: 'one-light-2020', depth_mm: 0.4 }]), [
    'sweepReaches',
    'sweepOrderOnce',
    'sweepWhy',
  ]);
  assert.deepEqual(say([]), ['sweepWhy']);
});
