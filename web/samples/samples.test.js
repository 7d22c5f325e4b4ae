// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { samples } from './generate.js';
import { pyramid } from './shapes.js';
import { checkSolid, cross, dot, fillHoles, subtract } from './solid.js';
import { readStl, writeStl } from './stl.js';

/** @typedef {import('./solid.js').Mesh} Mesh */
/** @typedef {import('./solid.js').Point} Point */

/** Returns the distance of a point from a triangle [Ericson 2005, §5.1.5], by projection and clamping to the edges. */
function distanceToTriangle(/** @type {Point} */ p, /** @type {Point[]} */ [a, b, c]) {
  const normal = cross(subtract(b, a), subtract(c, a));
  const length = Math.sqrt(dot(normal, normal));
  const edges = [
    [a, b],
    [b, c],
    [c, a],
  ];
  const inside = edges.every(([from, to]) => dot(cross(subtract(to, from), subtract(p, from)), normal) >= 0);
  if (inside) return Math.abs(dot(subtract(p, a), normal)) / length;
  return Math.min(
    ...edges.map(([from, to]) => {
      const along = subtract(to, from);
      const t = Math.min(1, Math.max(0, dot(subtract(p, from), along) / dot(along, along)));
      return Math.hypot(...subtract(p, /** @type {Point} */ (from.map((x, i) => x + t * along[i]))));
    }),
  );
}

test('A sample’s file has zero normals, which compress, and the corners of its facets', () => {
  const bytes = writeStl(
    {
      positions: [
        [1, 2, 3],
        [4, 5, 6],
        [7, 8, 10],
      ],
      triangles: [[0, 1, 2]],
    },
    'test',
  );
  assert.deepEqual([...new Float32Array(bytes.slice(84, 132).buffer)], [0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 10]);
});

for (const { id, mesh, centreMm, credit } of samples) {
  test(`The sample ${id} is a closed, outward oriented 2-manifold after a round trip through its file`, () => {
    const check = checkSolid(readStl(writeStl(mesh, 'test')));
    assert.equal(check.openEdges, 0);
    assert.equal(check.nonManifoldEdges, 0);
    assert.equal(check.nonManifoldVertices, 0);
    assert.equal(check.degenerateTriangles, 0);
    assert.ok(check.volume > 7_000, `the volume is ${check.volume} mm³`);
    assert.ok(Math.abs(check.min[2]) < 3, `it stands at z = ${check.min[2]}`);
  });

  test(`The centre proposed for ${id} lies within 3 mm of its surface, and its credit is named`, () => {
    const distance = Math.min(
      ...mesh.triangles.map((corners) =>
        distanceToTriangle(
          centreMm,
          corners.map((corner) => mesh.positions[corner]),
        ),
      ),
    );
    assert.ok(distance < 3, `it is ${distance} mm away`);
    assert.notEqual(credit, '');
  });
}

test('The volume of the pyramid is a third of its base times its height', () => {
  assert.ok(Math.abs(checkSolid(pyramid()).volume - (120 * 120 * 80) / 3) < 1e-6);
});

test('A missing triangle gives three open edges and is filled to the same volume', () => {
  const solid = pyramid();
  const open = { positions: solid.positions, triangles: solid.triangles.slice(1) };
  assert.equal(checkSolid(open).openEdges, 3);
  const filled = checkSolid(fillHoles(open));
  assert.equal(filled.openEdges, 0);
  assert.ok(Math.abs(filled.volume - checkSolid(solid).volume) < 1e-6);
});

test('A duplicate triangle gives a non-manifold edge, two touching tips a non-manifold vertex', () => {
  const solid = pyramid();
  const twice = { positions: solid.positions, triangles: [...solid.triangles, solid.triangles[2]] };
  assert.equal(checkSolid(twice).nonManifoldEdges, 3);
  const upsideDown = solid.triangles.map(([a, b, c]) => [a, c, b].map((v) => (v === 4 ? 4 : v + 5)));
  const touching = /** @type {Mesh} */ ({
    positions: [...solid.positions, ...solid.positions.slice(0, 4).map(([x, y]) => [x, y, 160])],
    triangles: [...solid.triangles, ...upsideDown],
  });
  assert.equal(checkSolid(touching).nonManifoldVertices, 1);
  assert.equal(checkSolid(touching).openEdges, 0);
});
