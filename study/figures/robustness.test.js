// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { byPattern, moreCarvedSurvivesMore, robustness } from './robustness.js';

test('medians are of the published search, by pattern, without what does not read', () => {
  const row = (/** @type {string} */ search, /** @type {string} */ modules, /** @type {number | null} */ blur) => ({
    search,
    modules,
    blur_modules: blur,
  });
  const rows = [
    row('papp-2022', 'square', 0.25),
    row('papp-2022', 'square', 0.5),
    row('papp-2022', 'none', null),
    row('papp-2022-literal', 'square', 0.75),
    row('ours', 'none', 1),
  ];
  assert.deepEqual(byPattern(rows, 'blur_modules'), { square: 0.375 });
  assert.deepEqual(byPattern(rows, 'blur_modules', 'papp-2022-literal'), { square: 0.75 });
});

test('pairs of patterns are judged by how much they carve', () => {
  assert.deepEqual(moreCarvedSurvivesMore({ none: 0.5, 'thick-plus': 0.6, square: 0.5 }), { holds: 2, of: 3 });
  assert.deepEqual(moreCarvedSurvivesMore({ none: 0.5 }), { holds: 0, of: 0 });
});

test('the patterns that the paper could test are counted apart', () => {
  const blurs = { 'thin-plus': 0.1, square: 0.5, diamond: 0.4, 'thick-plus': 0.3, none: 0.6 };
  const rows = Object.entries(blurs).map(([modules, blur]) => ({
    search: 'papp-2022',
    modules,
    blur_modules: blur,
    tilt_deg: 10,
  }));
  const { with: values } = robustness.find(rows, {})[0];
  assert.deepEqual(values, { holds: 7, of: 10, paperHolds: 0, paperOf: 3 });
});
