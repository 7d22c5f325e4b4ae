// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';

import { LiveView } from './live_view.js';

test('A search goes on after its first pass; a first pass of over a second turns it off', async (context) => {
  let now = 0;
  context.mock.method(performance, 'now', () => now);
  let isWanted = true;
  const live = new LiveView(() => isWanted);
  /** @type {number | undefined} */ let roughMm;
  const carveIn = (/** @type {number} */ firstMs, /** @type {number} */ restMs) =>
    live.carve(
      async (untilShown) => {
        now += untilShown ? firstMs : restMs;
        return { meanMm: untilShown ? 0.4 : 0.5, maxMm: 1 };
      },
      ({ meanMm }) => (roughMm = meanMm),
    );
  assert.ok(live.isOn);
  assert.equal((await carveIn(900, 5000))?.meanMm, 0.5);
  assert.equal(roughMm, 0.4);
  assert.ok(live.isOn);
  await carveIn(1100, 0);
  assert.ok(!live.isOn);
  isWanted = false;
  live.reset();
  assert.ok(!live.isOn);
  isWanted = true;
  assert.ok(live.isOn);
  const nothing = await live.carve(async (untilShown) => {
    assert.ok(untilShown, 'nothing is shown, so nothing goes on');
    now += 1;
    live.reset();
    now += 1100;
    return null;
  });
  assert.equal(nothing, null);
  assert.ok(live.isOn, 'it began before the user switched it');
});
