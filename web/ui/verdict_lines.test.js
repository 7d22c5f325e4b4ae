// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { notOffered } from './verdict_lines.js';

test('A remedy that several checks want is offered once', () => {
  const deeper = { code: 'engrave-deeper', values: {}, changes: [{ setting: 'preset', value: 'robust' }] };
  const larger = { code: 'allow-larger', values: {}, changes: [{ setting: 'maxSizeMm', value: '60' }] };
  const largest = { ...larger, changes: [{ setting: 'maxSizeMm', value: '80' }] };
  const elsewhere = { code: 'another-spot', values: {} };
  const others = notOffered([deeper]);
  assert.deepEqual(others([deeper, larger, elsewhere]), [larger, elsewhere]);
  assert.deepEqual(others([larger, largest, elsewhere]), [largest]);
});
