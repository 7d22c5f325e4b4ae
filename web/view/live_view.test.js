// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';

import { LiveView } from './live_view.js';

test('a search that takes more than a second turns it off, until the user switches it', async (context) => {
  let now = 0;
  context.mock.method(performance, 'now', () => now);
  let isWanted = true;
  const live = new LiveView(() => isWanted);
  const searchTaking = (/** @type {number} */ ms) =>
    live.time(async () => {
      now += ms;
      return 'found';
    });
  assert.ok(live.isOn);
  assert.equal(await searchTaking(900), 'found');
  assert.ok(live.isOn);
  await searchTaking(1100);
  assert.ok(!live.isOn);
  isWanted = false;
  live.reset();
  assert.ok(!live.isOn);
  isWanted = true;
  assert.ok(live.isOn);
  await live.time(async () => {
    now += 1;
    live.reset();
    now += 1100;
  });
  assert.ok(live.isOn, 'it began before the user switched it');
});
