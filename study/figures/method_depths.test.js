// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  isPaperOrder,
  oneLightOfSelfShadows,
  readsAsDesigned,
  selfShadowsTimesWhole,
  typical,
  wholeIsAsSelfShadows,
} from './method_depths.js';

const depths = (/** @type {Record<string, number>} */ byMethod) =>
  Object.entries(byMethod).map(([method, mm]) => ({ method, depth_mm: mm }));

test('the paper’s order of methods is by depth', () => {
  assert.equal(isPaperOrder(depths({ 'one-light-2020': 0.2, 'papp-2022': 0.4, 'self-shadow-2019': 0.9 })), true);
  assert.equal(isPaperOrder(depths({ 'one-light-2020': 0.5, 'papp-2022': 0.4, 'self-shadow-2019': 0.9 })), false);
  assert.equal(isPaperOrder(depths({ 'papp-2022': 0.4, 'self-shadow-2019': 0.9 })), undefined);
});

test('a depth of 2020 is a fraction of that of 2019 where both were measured', () => {
  assert.equal(oneLightOfSelfShadows(depths({ 'one-light-2020': 0.5, 'self-shadow-2019': 1 })), 0.5);
  assert.equal(oneLightOfSelfShadows(depths({ 'self-shadow-2019': 1 })), undefined);
});

test('whole modules are as deep as those of 2019 within a quarter, up or down', () => {
  const judged = (/** @type {number} */ peng) =>
    wholeIsAsSelfShadows(depths({ 'self-shadow-2019': peng, 'papp-2022-whole-modules': 0.8 }));
  assert.deepEqual([0.63, 0.65, 0.99, 1.01].map(judged), [false, true, true, false]);
  assert.equal(selfShadowsTimesWhole(depths({ 'self-shadow-2019': 2, 'papp-2022-whole-modules': 0.8 })), 2.5);
  assert.equal(wholeIsAsSelfShadows(depths({ 'self-shadow-2019': 2 })), undefined);
});

test('a method’s codes are read where two in five tries are, on models that have been measured', () => {
  const rows = [28, 29, 72].map((designed) => ({ method: 'a', designed }));
  assert.deepEqual(readsAsDesigned(rows, 'a'), { holds: 2, of: 3 });
  assert.deepEqual(readsAsDesigned(rows, 'b'), { holds: 0, of: 0 });
});

test('a median is over the models that have a value', () => {
  const rows = [1000, 3000, null].map((ms) => ({ method: 'a', search_ms: ms }));
  assert.equal(typical(rows, 'a', 'search_ms'), 2000);
  assert.ok(Number.isNaN(typical(rows, 'b', 'search_ms')));
});
