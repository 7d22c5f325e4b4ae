// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';

import { LiveView } from './live_view.js';

test('a search that takes more than a second turns it off, until the user turns it off and on', async (context) => {
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
  live.update();
  assert.ok(!live.isOn);
  isWanted = true;
  assert.ok(live.isOn);
});
