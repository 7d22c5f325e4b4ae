// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  handlePositions,
  roundedSize,
  scaleBetween,
  snappedRotation,
  squareMaps,
  turnBetween,
  twistBetween,
} from './handle_geometry.js';

/** @typedef {[number, number]} Point */

/** @param {Point} actual @param {Point} expected */
function near(actual, expected) {
  actual.forEach((value, axis) => assert.ok(Math.abs(value - expected[axis]) < 1e-9, `${actual} is not ${expected}`));
}

/** @type {Point[]} */ const kUpright = [
  [100, 50],
  [300, 50],
  [300, 250],
  [100, 250],
];

/**
 * Returns the corners of a square of half edge 1, turned about its vertical axis, in a pinhole's view.
 * @returns {Point[]}
 */
function inPerspective() {
  const [c, s] = [Math.cos(0.7), Math.sin(0.7)];
  return /** @type {Point[]} */ (
    [
      [-1, 1],
      [1, 1],
      [1, -1],
      [-1, -1],
    ].map(([u, v]) => pinhole(u, v, c, s))
  );
}

/** @param {number} u @param {number} v @param {number} c @param {number} s @returns {Point} */
const pinhole = (u, v, c, s) => [400 + (500 * u * c) / (5 + u * s), 300 - (500 * v) / (5 + u * s)];

test('A square seen from the front is mapped by its edges', () => {
  const { toScreen, toSquare } = squareMaps(kUpright);
  near(toScreen([0, 0]), [200, 150]);
  near(toScreen([1, 1]), [300, 50]);
  near(toSquare([100, 250]), [-1, -1]);
  near(toSquare([200, 100]), [0, 0.5]);
});

test('Points of a square are projected like a pinhole camera does, and back', () => {
  const { toScreen, toSquare } = squareMaps(inPerspective());
  for (const [u, v] of /** @type {Point[]} */ ([
    [0, 0],
    [0.5, -0.25],
    [-0.9, 0.9],
    [1.3, 1.2],
  ])) {
    const seen = pinhole(u, v, Math.cos(0.7), Math.sin(0.7));
    near(toScreen([u, v]), seen);
    near(toSquare(seen), [u, v]);
  }
});

test('The turning handle is beyond the upper edge for every rotation', () => {
  const { move, turn, size } = handlePositions(kUpright);
  near(move, [200, 150]);
  near(turn, [200, 16]);
  near(size, [300, 250]);
  const quarter = [kUpright[3], kUpright[0], kUpright[1], kUpright[2]]; // the upper left is now at the lower left
  near(handlePositions(quarter).turn, [66, 150]);
});

test('Rotations snap to quarter turns within five degrees, and stay within half a turn', () => {
  const cases = [
    [3, 0],
    [-5, 0],
    [5.4, 5],
    [-7.6, -8],
    [86, 90],
    [357, 0],
    [540, 180],
    [-180, 180],
    [-92, -90],
    [723.2, 0],
  ];
  for (const [deg, expected] of cases) assert.equal(snappedRotation(deg), expected, `${deg}`);
  assert.ok(Object.is(snappedRotation(-2), 0), 'no minus zero in a field');
});

test('A drag around the middle turns anticlockwise for growing angles', () => {
  assert.equal(Math.round(turnBetween([1, 0], [0, 1])), 90);
  assert.equal(Math.round(turnBetween([0, 1.3], [0.5, 0.5])), -45);
});

test('A drag of a corner scales by the farther of its coordinates', () => {
  assert.equal(scaleBetween([1, -1], [1.5, -1.2]), 1.5);
  assert.equal(scaleBetween([1, -1], [0.2, -0.5]), 0.5);
});

test('Two fingers turn and scale by the line between them', () => {
  const { turnDeg, factor } = twistBetween(
    [
      [0, 0],
      [100, 0],
    ],
    [
      [0, 0],
      [0, -200],
    ],
  );
  assert.equal(Math.round(turnDeg), 90);
  assert.equal(factor, 2);
  assert.deepEqual(
    twistBetween(
      [
        [5, 5],
        [15, 5],
      ],
      [
        [25, 5],
        [35, 5],
      ],
    ),
    { turnDeg: -0, factor: 1 },
  );
});

test('Sizes are rounded like typed ones and stay in range', () => {
  assert.equal(roundedSize(34.27, 5, 1000), 34.5);
  assert.equal(roundedSize(9.87, 5, 1000), 9.9);
  assert.equal(roundedSize(2, 5, 1000), 5);
  assert.equal(roundedSize(2000, 5, 1000), 1000);
});
