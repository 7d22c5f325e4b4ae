// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cases, sentence } from './say.js';

test('one case and two cases are said as such', () => {
  const words = [
    [1, 1],
    [0, 1],
    [2, 2],
    [1, 2],
    [0, 2],
    [3, 3],
  ].map(([holds, of]) => sentence('en', cases({ holds, of })));
  assert.deepEqual(words, [
    'in the only case',
    'not in the only case',
    'in both cases',
    'in 1 of 2 cases',
    'in none of 2 cases',
    'in all 3 cases',
  ]);
});
