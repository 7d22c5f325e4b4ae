// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { tooSmall } from './module_size.js';

test('printable modules need no advice, down to the exact size', () => {
  assert.equal(tooSmall(29, 29 * 0.6, 0.6), undefined);
  assert.equal(tooSmall(29, 40, 0.6), undefined);
});

test('advice about small modules names the needed width and the number that fits', () => {
  // 33 modules of 0.9 mm are 29.7 mm wide. 24 mm has room for 26; the largest symbol within 26 has 25.
  const size = tooSmall(33, 24, 0.9);
  assert.ok(size);
  assert.ok(Math.abs(size.moduleMm - 24 / 33) < 1e-12);
  assert.ok(Math.abs(size.neededMm - 29.7) < 1e-12);
  assert.equal(size.printable, 25);
});

test('the largest printable symbol is found at its exact width', () => {
  assert.equal(tooSmall(29, 25 * 0.6, 0.6)?.printable, 25);
  assert.equal(tooSmall(29, 25 * 0.6 - 1e-3, 0.6)?.printable, 21);
});

test('if not even the smallest symbol prints, none is named', () => {
  assert.equal(tooSmall(29, 12, 0.6)?.printable, undefined);
});
