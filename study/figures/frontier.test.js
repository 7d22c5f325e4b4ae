// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { betterThanDefault, leastDepthThatReads } from './frontier.js';

const row = (/** @type {string} */ method, /** @type {number} */ mm, /** @type {number} */ printed) => ({
  method,
  depth_mm: mm,
  printed,
});
const kRows = [
  row('papp-2022', 0.2, 10),
  row('papp-2022', 0.4, 50),
  row('even-depth', 0.5, 70),
  row('ours-for-design', 0.2, 72),
];

test('our default is beaten by methods that reach more reads at no more depth, and not by ours', () => {
  assert.deepEqual(betterThanDefault(kRows, row('ours', 0.3, 30)), []);
  assert.deepEqual(betterThanDefault(kRows, row('ours', 0.3, 29)), ['papp-2022']);
  assert.deepEqual(betterThanDefault(kRows, row('ours', 0.6, 60)), ['even-depth']);
  assert.deepEqual(betterThanDefault(kRows, row('ours', 0.1, 0)), []);
  assert.equal(betterThanDefault(kRows, undefined), undefined);
});

test('the least depth that reads is that of a level that was carved', () => {
  assert.equal(leastDepthThatReads(kRows, 'papp-2022'), 0.4);
  assert.equal(leastDepthThatReads([row('papp-2022', 0.2, 28)], 'papp-2022'), undefined);
});
