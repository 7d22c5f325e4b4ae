// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';

import { HoverPreview } from './hover_preview.js';

test('The exact place is looked for once the mouse rests, however long the estimate took', async (context) => {
  let now = 1000;
  context.mock.method(performance, 'now', () => now);
  context.mock.timers.enable({ apis: ['setTimeout'] });
  let settled = 0;
  let estimateMs = 0;
  const client = {
    hover: async () => {
      now += estimateMs;
      return { code: {} };
    },
    settle: async () => {
      ++settled;
      return null;
    },
  };
  const preview = new HoverPreview(
    /** @type {any} */ (client),
    /** @type {any} */ ({ show: () => {}, hide: () => {} }),
    /** @type {any} */ ({ isOn: false }),
  );
  preview.setEnabled(true);
  const pass = async (/** @type {number} */ ms) => {
    await new Promise(setImmediate);
    now += ms;
    context.mock.timers.tick(ms);
    await new Promise(setImmediate);
  };

  estimateMs = 30;
  preview.move(1, 1);
  await pass(5);
  assert.equal(settled, 0, 'after 35 ms the mouse may still move');
  preview.move(2, 2);
  await pass(5);
  assert.equal(settled, 0, 'it moved again');
  await pass(10);
  assert.equal(settled, 1, 'it has rested for 45 ms, 30 of them while its code was estimated');

  estimateMs = 500;
  preview.move(3, 3);
  await pass(1);
  assert.equal(settled, 2, 'it rested while its code was estimated');
});
