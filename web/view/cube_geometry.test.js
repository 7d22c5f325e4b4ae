// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { visibleFaces } from './cube_geometry.js';

const round = (/** @type {number[]} */ values) => values.map((v) => Math.round(v * 1000) / 1000 + 0);

test('From the front only the front is visible, upright', () => {
  const faces = visibleFaces(
    [
      [1, 0, 0],
      [0, 0, 1],
      [0, -1, 0],
    ],
    20,
  );
  assert.deepEqual(
    faces.map(({ name }) => name),
    ['front'],
  );
  assert.deepEqual(round(faces[0].matrix), [20, 0, 0, 20, 0, 0]);
});

test('From above, the back is at the upper edge of the top', () => {
  const [top] = visibleFaces(
    [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ],
    10,
  );
  assert.equal(top.name, 'top');
  assert.deepEqual(round(top.matrix), [10, 0, 0, 10, 0, 0]);
});

test('From a corner three faces are visible, centred where the cube’s are', () => {
  const s = Math.SQRT1_2;
  const t = 1 / Math.sqrt(3);
  const faces = visibleFaces(
    [
      [s, s, 0],
      [-t * s, t * s, 2 * t * s],
      [t, -t, t],
    ],
    10,
  );
  assert.deepEqual(faces.map(({ name }) => name).sort(), ['front', 'right', 'top']);
  const middles = Object.fromEntries(faces.map(({ name, matrix }) => [name, round(matrix.slice(4))]));
  assert.deepEqual(middles.top, [0, round([-10 * 2 * t * s])[0]]);
  assert.equal(middles.front[0], -middles.right[0]);
  assert.equal(middles.front[1], middles.right[1]);
  assert.ok(middles.front[0] < 0, 'front is left of right');
});
