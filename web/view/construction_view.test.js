// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { numbered, stepsOf } from './construction_view.js';

/** @param {number[]} variancesMm2 @param {number | null} chosen */
const tried = (variancesMm2, chosen) => ({
  eyeMm: 250,
  closestMm: 10,
  largestMm: 10,
  squareMm: 14,
  variancesMm2,
  chosen,
  colours: { plane: '#000', projection: '#000', silhouette: '#000', square: '#000', directions: '#000' },
});

test('The legend lists a few directions, and the first and the chosen one of many', () => {
  assert.equal(stepsOf(tried([12.34, 4.12, 0.056], 2)), '1:\u00a012.3 → 2:\u00a04.1 → 3:\u00a00.056\u00a0✓');
  assert.equal(stepsOf(tried([12.34], null)), '1:\u00a012.3');
  assert.equal(stepsOf(tried([9, 8, 7, 6, 5, 4, 3, 2, 1], 7)), '1:\u00a09.0 … 8:\u00a02.0\u00a0✓');
});

test('Arrows have their numbers where these do not overlap, the chosen one in any case', () => {
  const names = (/** @type {[number, number][]} */ tips, /** @type {number | null} */ chosen) =>
    numbered(tips, chosen).map(([name]) => name);
  assert.deepEqual(
    names(
      [
        [0, 0],
        [100, 0],
        [104, 0],
      ],
      2,
    ),
    ['3', '1'],
  );
  assert.deepEqual(
    names(
      [
        [0, 0],
        [50, 0],
        [100, 0],
      ],
      null,
    ),
    ['1', '2', '3'],
  );
  assert.deepEqual(numbered([null, null], 0), []);
});
