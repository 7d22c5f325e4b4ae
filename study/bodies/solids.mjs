// SPDX-License-Identifier: GPL-3.0-or-later
// Closed solids whose corners are exact in 32-bit floats, so that solids that touch share their planes bit for bit.

/** @typedef {[number, number, number]} Point */
/** @typedef {{ positions: Point[], triangles: Point[] }} Mesh a closed surface, mm, triangles counter-clockwise from outside */

const GRID = 64; // steps in a millimetre
const SPHERE_ROUNDS = 2; // of subdivision: 320 triangles

/** Returns the nearest number on the grid. @param {number} x */
const onGrid = (x) => Math.round(x * GRID) / GRID;

/** Returns the solid over a counter-clockwise outline. @param {[number, number][]} outline @param {number} height @returns {Mesh} */
function extruded(outline, height) {
  const n = outline.length;
  /** @type {Point[]} */ const triangles = [];
  for (let i = 1; i + 1 < n; i += 1) triangles.push([0, i + 1, i], [n, n + i, n + i + 1]);
  for (let i = 0; i < n; i += 1) {
    const next = (i + 1) % n;
    triangles.push([i, next, n + next], [i, n + next, n + i]);
  }
  /** @type {(z: number) => Point[]} */
  const level = (z) => outline.map(([x, y]) => [x, y, z]);
  return { positions: [...level(0), ...level(height)], triangles };
}

/** Returns a box from the origin. @param {Point} size @returns {Mesh} */
export function box([width, depth, height]) {
  return extruded([[0, 0], [width, 0], [width, depth], [0, depth]], height); // prettier-ignore
}

/** Returns a prism that fills a box from the origin. @param {Point} size @param {number} sides @returns {Mesh} */
export function prism([width, depth, height], sides) {
  /** @type {[number, number][]} */
  const outline = Array.from({ length: sides }, (_, i) => {
    const angle = (2 * Math.PI * i) / sides;
    return [onGrid((width / 2) * (1 + Math.cos(angle))), onGrid((depth / 2) * (1 + Math.sin(angle)))];
  });
  return extruded(outline, height);
}

/** Returns an ellipsoid that fills a box from the origin. @param {Point} size @returns {Mesh} */
export function sphere(size) {
  /** @type {Point[]} */
  const positions = [[0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, -1]]; // prettier-ignore
  /** @type {Point[]} */ let triangles = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [5, 2, 1], [5, 3, 2], [5, 4, 3], [5, 1, 4]]; // prettier-ignore
  for (let round = 0; round < SPHERE_ROUNDS; round += 1) {
    /** @type {Map<string, number>} */ const middles = new Map();
    const middle = (/** @type {number} */ a, /** @type {number} */ b) => {
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      const known = middles.get(key);
      if (known !== undefined) return known;
      const sum = positions[a].map((x, k) => x + positions[b][k]);
      const length = Math.hypot(...sum);
      positions.push(/** @type {Point} */ (sum.map((x) => x / length)));
      middles.set(key, positions.length - 1);
      return positions.length - 1;
    };
    triangles = triangles.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
      return /** @type {Point[]} */ ([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]); // prettier-ignore
    });
  }
  return {
    positions: positions.map((p) => /** @type {Point} */ (p.map((x, k) => onGrid((size[k] / 2) * (1 + x))))),
    triangles,
  };
}

/** Returns a mesh that is moved. @param {Mesh} mesh @param {Point} by @returns {Mesh} */
export function moved({ positions, triangles }, by) {
  return { positions: positions.map((p) => /** @type {Point} */ (p.map((x, k) => x + by[k]))), triangles };
}

/** Returns a solid with another one cut out of its inside: a cavity. @param {Mesh} solid @param {Mesh} hollow @returns {Mesh} */
export function hollowed(solid, hollow) {
  const first = solid.positions.length;
  return {
    positions: [...solid.positions, ...hollow.positions],
    triangles: [
      ...solid.triangles,
      ...hollow.triangles.map(([a, b, c]) => /** @type {Point} */ ([a + first, c + first, b + first])),
    ],
  };
}

/**
 * Returns a box with a pocket from its top face, which another box may fill flush.
 * @param {Point} size
 * @param {Point} pocket  its size
 * @param {Point} at  the pocket's least corner; the pocket ends at the top
 * @returns {Mesh}
 */
export function pocketed(size, pocket, at) {
  const outer = box(size);
  const inner = moved(box(pocket), at);
  // Corners of a box: 0 to 3 below, 4 to 7 above. Its first four triangles alternate between below and above.
  const first = outer.positions.length;
  const floor = inner.triangles.filter((triangle) => triangle.every((v) => v < 4));
  const walls = (/** @type {Mesh} */ mesh) =>
    mesh.triangles.filter((triangle) => triangle.some((v) => v < 4) && triangle.some((v) => v >= 4));
  /** @type {Point[]} */ const rim = [];
  for (let i = 0; i < 4; i += 1) {
    const next = (i + 1) % 4;
    rim.push([4 + i, 4 + next, first + 4 + next], [4 + i, first + 4 + next, first + 4 + i]);
  }
  const reversed = [...floor, ...walls(inner)].map(
    ([a, b, c]) => /** @type {Point} */ ([a + first, c + first, b + first]),
  );
  return {
    positions: [...outer.positions, ...inner.positions],
    triangles: [
      ...outer.triangles.filter((triangle) => triangle.every((v) => v < 4)),
      ...walls(outer),
      ...rim,
      ...reversed,
    ],
  };
}
