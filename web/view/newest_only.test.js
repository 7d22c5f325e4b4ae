// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NewestOnly } from './newest_only.js';

const settled = () =>
  new Promise((resolve) => {
    setTimeout(resolve);
  });

test('While one task runs, only the newest other one waits', async () => {
  /** @type {number[]} */ const begun = [];
  /** @type {(() => void)[]} */ const ends = [];
  const queue = new NewestOnly((/** @type {number} */ task) => {
    begun.push(task);
    return new Promise((resolve) => {
      ends.push(() => resolve(undefined));
    });
  });
  [1, 2, 3].forEach((task) => queue.ask(task));
  assert.deepEqual(begun, [1]);
  ends[0]();
  await settled();
  assert.deepEqual(begun, [1, 3]);
  ends[1]();
  await settled();
  assert.deepEqual(begun, [1, 3]);
});

test('A waiting task can be dropped', async () => {
  /** @type {number[]} */ const begun = [];
  const queue = new NewestOnly(async (/** @type {number} */ task) => {
    begun.push(task);
  });
  queue.ask(1);
  queue.ask(2);
  queue.forget();
  await settled();
  assert.deepEqual(begun, [1]);
});
