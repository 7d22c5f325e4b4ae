// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { searchTimes, secondsOf } from './search_times.js';

test('times are medians in seconds', () => {
  assert.equal(
    secondsOf(
      [
        { method: 'a', search_ms: 1000 },
        { method: 'a', search_ms: 4000 },
        { method: 'b', search_ms: 1 },
      ],
      'a',
    ),
    2.5,
  );
});

test('the paper’s search is compared with both of Peng’s, and holds if it is faster than either', () => {
  const said = (/** @type {number} */ papp) => {
    const times = { 'papp-2022': papp, 'self-shadow-2019': 30_000, 'one-light-2020': 90_000 };
    const rows = Object.entries(times).map(([method, ms]) => ({ method, search_ms: ms }));
    return searchTimes.find(rows, {})[1];
  };
  assert.equal(said(40_000).say, 'timesPaperFails');
  assert.deepEqual(said(2000), {
    say: 'timesPaperHolds',
    with: { papp: { number: 2, digits: 1 }, shadow: { number: 30, digits: 0 }, light: { number: 90, digits: 0 } },
  });
});
