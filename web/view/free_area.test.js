// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { freeArea } from './free_area.js';

test('Without obstacles the whole stage except its margin is free', () => {
  assert.deepEqual(freeArea({ width: 900, height: 800 }, []), { x: 12, y: 12, width: 876, height: 776 });
});

test('A toolbar at the upper right leaves room for a window at the upper left', () => {
  const area = freeArea({ width: 904, height: 800 }, [{ x: 500, y: 12, width: 392, height: 36 }]);
  assert.deepEqual([area.x, area.y], [12, 12]);
  assert.ok(area.x + area.width <= 500 - 12);
  assert.ok(area.height >= 720);
});

test('On a phone the area is between toolbar and hint', () => {
  const area = freeArea({ width: 360, height: 400 }, [
    { x: 40, y: 12, width: 308, height: 44 },
    { x: 60, y: 350, width: 240, height: 34 },
  ]);
  assert.deepEqual(area, { x: 12, y: 68, width: 336, height: 270 });
});

test('No area overlaps an obstacle', () => {
  let seed = 7;
  const random = (/** @type {number} */ most) => {
    seed = (seed * 48271) % 2147483647;
    return Math.floor((seed / 2147483647) * most);
  };
  for (let round = 0; round < 50; round += 1) {
    const obstacles = Array.from({ length: 1 + random(6) }, () => ({
      x: random(700),
      y: random(500),
      width: 20 + random(200),
      height: 20 + random(100),
    }));
    const { x, y, width, height } = freeArea({ width: 800, height: 600 }, obstacles);
    for (const o of obstacles) {
      assert.ok(
        x + width <= o.x || o.x + o.width <= x || y + height <= o.y || o.y + o.height <= y || width * height === 0,
      );
    }
  }
});
