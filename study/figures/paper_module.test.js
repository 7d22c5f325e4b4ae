// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { betterThanDefault } from './paper_module.js';

const row = (/** @type {string} */ method, /** @type {number} */ printed, /** @type {number} */ depth) => ({
  method,
  printed,
  depth_mm: depth,
});

test('methods of others for the sky are compared with the default at no more depth', () => {
  const ours = row('ours', 40, 0.7);
  assert.deepEqual(
    betterThanDefault([ours, row('papp-2022', 50, 0.6), row('groove-2018', 50, 0.8), row('self-shadow-2019', 40, 0.5)]),
    ['papp-2022'],
  );
  assert.deepEqual(betterThanDefault([ours, row('ours-whole-modules', 60, 0.6), row('one-light-2020', 60, 0.5)]), []);
  assert.equal(betterThanDefault([row('papp-2022', 50, 0.6)]), undefined);
});
