// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { durationOf } from './parts_panel.js';

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
