// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Signal } from './signal.js';

test('A signal tells its listeners in order, and none that registers later', () => {
  /** @type {Signal<[number, string]>} */ const signal = new Signal();
  /** @type {any[]} */ const calls = [];
  signal.emit(0, 'a');
  signal.on((...values) => void calls.push(['first', ...values]));
  signal.on((...values) => void calls.push(['second', ...values]));
  signal.emit(1, 'b');
  assert.deepEqual(calls, [
    ['first', 1, 'b'],
    ['second', 1, 'b'],
  ]);
});
