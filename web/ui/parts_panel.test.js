// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { downloadWords, durationOf, overWords } from './parts_panel.js';

test('The remaining time is worded as people say it', () => {
  const minute = 60_000,
    hour = 60 * minute;
  const said = /** @type {[number, string][]} */ ([
    [0, '1 second'],
    [1400, '1 second'],
    [17_000, '17 seconds'],
    [44_000, '40 seconds'],
    [95_000, '2 minutes'],
    [20 * minute, '20 minutes'],
    [80 * minute, '80 minutes'],
    [100 * minute, '2 hours'],
    [25 * hour, '25 hours'],
  ]);
  for (const [ms, words] of said) assert.equal(durationOf(ms), words);
});

test('A finished batch does not count failed parts as engraved', () => {
  assert.equal(overWords({ done: 3, failed: 0 }), '3 parts are engraved');
  assert.equal(overWords({ done: 2, failed: 1 }), '2 engraved, 1 failed');
});

test('The download says how many parts it gives until all are done', () => {
  const words = [0, 1, 3].map((done) => downloadWords({ done, count: 3 }));
  assert.deepEqual(words, ['Download as ZIP', 'Download 1 of 3 as ZIP', 'Download as ZIP']);
});
