// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { savedByFlips, triesByFlips } from './symbol_flips.js';

const row = (
  /** @type {string} */ model,
  /** @type {string} */ flips,
  /** @type {number} */ mm,
  /** @type {number} */ printed,
) => ({ model, search: 'ours', flips, depth_mm: mm, printed });
const kRows = [
  row('a', 'none', 1, 50),
  row('a', 'ours', 0.75, 48),
  row('b', 'none', 2, 40),
  row('b', 'ours', 1, 44),
  row('c', 'ours', 1, 0),
];

test('what flips save and cost is the median over the models that have both', () => {
  assert.equal(savedByFlips(kRows, 'ours', 'ours'), 0.375);
  assert.equal(triesByFlips(kRows, 'ours', 'ours'), 1);
});
