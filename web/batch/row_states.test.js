// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { RowStates } from './row_states.js';

test('Counts rows by state and keeps the reasons of failures', () => {
  const states = new RowStates(4);
  states.set(1, 'failed', 'why');
  states.set(2, 'done');
  states.set(9, 'done');
  assert.deepEqual(states.counts, { waiting: 2, running: 0, done: 1, failed: 1 });
  assert.equal(states.finished, 2);
  assert.equal(states.reasonOf(1), 'why');
  states.set(1, 'waiting');
  assert.equal(states.reasonOf(1), '');
  assert.deepEqual([states.next('waiting'), states.next('waiting', 2), states.next('failed')], [0, 3, -1]);
});

test('A page lists the rows of one state or of all', () => {
  const states = new RowStates(10);
  for (const index of [1, 4, 5, 9]) states.set(index, 'failed');
  assert.deepEqual(states.page('failed', 1, 2), [4, 5]);
  assert.deepEqual(states.page('failed', 3, 5), [9]);
  assert.deepEqual(states.page('all', 8, 5), [8, 9]);
  assert.deepEqual(states.page('done', 0, 5), []);
});
