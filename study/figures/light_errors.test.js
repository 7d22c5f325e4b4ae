// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { byError } from './light_errors.js';

test('methods stand in the order of their error; those that estimate no light are left out', () => {
  const row = (/** @type {string} */ method, /** @type {number | null} */ error) => ({
    method,
    light_error: error === null ? null : -error,
    light_error_size: error,
  });
  assert.deepEqual(byError([row('a', 0.5), row('a', 0.25), row('b', 0.125), row('c', null)]), [
    { method: 'b', size: 0.125, mean: -0.125 },
    { method: 'a', size: 0.375, mean: -0.375 },
  ]);
});
