// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { effects, lampStrengths } from './lamp_strengths.js';

const lamp = (/** @type {number} */ elevation, /** @type {number[]} */ ...depths) =>
  depths.map((depth, strength) => ({ modules: 'none', elevation, strength, depth_mm: depth }));

test('an elevation counts where the lamp has one effect at every strength', () => {
  assert.deepEqual(effects([...lamp(8, 0.7, 0.6), ...lamp(33, 0.7, 0.9), ...lamp(70, 0.9, 1.2)], 0.8), {
    shallower: [8],
    deeper: [70],
    either: [33],
  });
});

test('nothing is said of a pattern whose depth under the sky is not known', () => {
  const rows = [...lamp(8, 0.7), ...lamp(33, 0.7, 0.9), ...lamp(70, 0.9)];
  const sky = ['papp-2022', 'papp-2022-literal'].map((search, at) => ({
    model: 'plate',
    modules: 'none',
    lamps: 0,
    search,
    depth_mm: 0.8 + at,
  }));
  assert.deepEqual(
    lampStrengths.find(rows, { lamp_depths: sky }).map(({ say }) => say),
    ['strengthsSides', 'strengthsWhy'],
  );
  assert.deepEqual(lampStrengths.find(rows, {}), []);
});
