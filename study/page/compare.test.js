// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { distinct, frontierAt, groupBy, median, onModels, rises, tally, valuesBy } from './compare.js';

test('the median is the middle one, or the mean of the middle two', () => {
  assert.equal(median([3, 1, 2]), 2);
  assert.equal(median([4, 1, 2, 3]), 2.5);
  assert.ok(Number.isNaN(median([])));
});

test('rows are grouped in their order, and a measure is found by a key; what is empty is not there', () => {
  const rows = [
    { model: 'b', level: 1, mm: 0.5 },
    { model: 'a', level: 1, mm: 0.25 },
    { model: 'b', level: 2, mm: null },
  ];
  assert.deepEqual([...groupBy(rows, 'model').keys()], ['b', 'a']);
  assert.deepEqual(distinct(rows, 'level'), [1, 2]);
  assert.deepEqual(
    valuesBy(
      rows.filter(({ model }) => model === 'b'),
      'level',
      'mm',
    ),
    { 1: 0.5 },
  );
  assert.deepEqual(
    onModels(rows, (ofModel) => ofModel.length > 1),
    { holds: 1, of: 2 },
  );
});

test('what cannot be judged does not count', () => {
  assert.deepEqual(
    tally([1, 2, 3, 4], (item) => (item === 4 ? undefined : item > 1)),
    { holds: 2, of: 3 },
  );
});

test('values rise only if each is greater than the one before', () => {
  assert.equal(rises([1, 2, 3]), true);
  assert.equal(rises([1, 1, 3]), false);
  assert.equal(rises([1, undefined, 3]), undefined);
});

test('a frontier is the most reads at no more depth, linear between levels', () => {
  /** @type {[number, number][]} */
  const levels = [
    [0.6, 30],
    [0.2, 10],
    [0.4, 50],
  ];
  assert.equal(frontierAt(levels, 0.1), undefined);
  assert.equal(frontierAt(levels, 0.2), 10);
  assert.ok(Math.abs(Number(frontierAt(levels, 0.3)) - 30) < 1e-9);
  assert.equal(frontierAt(levels, 0.5), 50);
  assert.equal(frontierAt(levels, 2), 50);
  assert.equal(frontierAt([], 1), undefined);
  assert.equal(
    frontierAt(
      [
        [0.4, 20],
        [0.4, 30],
      ],
      0.4,
    ),
    30,
  );
});
