// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { colourCost, colourCostWithTower } from './colour_cost.js';

const kCost = {
  layers: 2,
  changes: 2,
  secondG: 0.1,
  firstWasteG: 0.18,
  secondWasteG: 0.12,
  wasteMinutes: 4.4,
  towerG: 22.3,
};

test('The cost lists filament changes, grams and minutes', () => {
  assert.equal(colourCost(kCost), '2 filament changes, 0.3\u00a0g and\u00a04\u00a0min of waste');
  assert.match(colourCost({ ...kCost, changes: 1 }), /^1 filament change,/);
  assert.match(colourCost({ ...kCost, firstWasteG: 14.6, secondWasteG: 10 }), / 25\sg and/);
});

test('On a printer without filament changes only their number is known', () => {
  const unpriced = { ...kCost, firstWasteG: null, secondWasteG: null, wasteMinutes: null };
  assert.equal(colourCost(unpriced), '2 filament changes');
});

test('A wipe tower is an addition', () => {
  assert.equal(
    colourCostWithTower(kCost),
    '2 filament changes, 0.3\u00a0g and\u00a04\u00a0min of waste; plus up to\u00a022\u00a0g for a wipe tower',
  );
  for (const towerG of [null, 0]) assert.equal(colourCostWithTower({ ...kCost, towerG }), colourCost(kCost));
});
