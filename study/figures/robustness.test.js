// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { byPattern, moreCarvedSurvivesMore } from './robustness.js';

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
