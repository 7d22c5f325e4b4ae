// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { secondsOf } from './search_times.js';

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
