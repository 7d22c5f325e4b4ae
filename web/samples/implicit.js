// SPDX-License-Identifier: GPL-3.0-or-later
// Closed meshes of solids given as distance functions, by surface nets [Gibson 1998].

/** @typedef {import('./solid.js').Mesh} Mesh */
/** @typedef {import('./solid.js').Point} Point */
/** @typedef {import('./solid.js').Triangle} Triangle */
/**
 * Distance to a solid's surface in mm, negative inside; need not be exact.
 * @typedef {(x: number, y: number, z: number) => number} Distance
 */

/** @param {Point} centre @param {Point} radii @returns {Distance} */
export const ellipsoid =
  ([cx, cy, cz], [rx, ry, rz]) =>
  (x, y, z) => {
    const [u, v, w] = [x - cx, y - cy, z - cz];
    const k0 = Math.hypot(u / rx, v / ry, w / rz);
    const k1 = Math.hypot(u / rx ** 2, v / ry ** 2, w / rz ** 2);
    return k1 === 0 ? -Math.min(rx, ry, rz) : (k0 * (k0 - 1)) / k1;
  };

/**
 * Returns a capsule whose radius changes evenly from one end to the other.
 * @param {Point} a
 * @param {Point} b
 * @param {number} ra
 * @param {number} rb
 * @returns {Distance}
 */
export const cone = (a, b, ra, rb) => (x, y, z) => {
  const along = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const from = [x - a[0], y - a[1], z - a[2]];
  const length2 = along[0] ** 2 + along[1] ** 2 + along[2] ** 2;
  const t = Math.min(1, Math.max(0, (from[0] * along[0] + from[1] * along[1] + from[2] * along[2]) / length2));
  return Math.hypot(from[0] - t * along[0], from[1] - t * along[1], from[2] - t * along[2]) - (ra + t * (rb - ra));
};

/**
 * Returns a union whose seam is rounded over `blendMm`.
 * @param {number} blendMm
 * @param {Distance[]} parts
 * @returns {Distance}
 */
export const blended =
  (blendMm, ...parts) =>
  (x, y, z) =>
    parts
      .map((part) => part(x, y, z))
      .reduce((a, b) => {
        const h = Math.max(blendMm - Math.abs(a - b), 0) / blendMm;
        return Math.min(a, b) - (h * h * blendMm) / 4;
      });

/** Returns the part of a solid above z = 0. @param {Distance} solid @returns {Distance} */
export const standing = (solid) => (x, y, z) => Math.max(solid(x, y, z), -z);

/**
 * Meshes a solid: one vertex in each cell that the surface crosses, at the mean of the crossings of its edges; one quad
 * across each crossed edge of the grid.
 * @param {Distance} distance
 * @param {Point} min     of a box around the solid, mm
 * @param {Point} max
 * @param {number} cellMm
 * @returns {Mesh}
 */
export function surfaceNet(distance, min, max, cellMm) {
  const counts = max.map((value, axis) => Math.ceil((value - min[axis]) / cellMm) + 1);
  const [nx, ny] = counts;
  const at = (/** @type {number} */ i, /** @type {number} */ j, /** @type {number} */ k) => i + nx * (j + ny * k);
  const values = new Float64Array(nx * ny * counts[2]);
  for (let k = 0; k < counts[2]; k += 1)
    for (let j = 0; j < ny; j += 1)
      for (let i = 0; i < nx; i += 1)
        values[at(i, j, k)] = distance(min[0] + i * cellMm, min[1] + j * cellMm, min[2] + k * cellMm);

  /** @type {Point[]} */ const positions = [];
  const vertexOf = new Map();
  for (let k = 0; k + 1 < counts[2]; k += 1)
    for (let j = 0; j + 1 < ny; j += 1)
      for (let i = 0; i + 1 < nx; i += 1) {
        const vertex = meanCrossing((di, dj, dk) => values[at(i + di, j + dj, k + dk)]);
        if (!vertex) continue;
        vertexOf.set(at(i, j, k), positions.length);
        positions.push([
          min[0] + (i + vertex[0]) * cellMm,
          min[1] + (j + vertex[1]) * cellMm,
          min[2] + (k + vertex[2]) * cellMm,
        ]);
      }

  /** @type {Triangle[]} */ const triangles = [];
  const steps = [1, nx, nx * ny];
  for (let k = 1; k + 1 < counts[2]; k += 1)
    for (let j = 1; j + 1 < ny; j += 1)
      for (let i = 1; i + 1 < nx; i += 1)
        for (let axis = 0; axis < 3; axis += 1) {
          const here = at(i, j, k);
          const [inside, next] = [values[here] < 0, values[here + steps[axis]] < 0];
          if (inside === next) continue;
          const [u, v] = [steps[(axis + 1) % 3], steps[(axis + 2) % 3]];
          const [a, b, c, d] = [here - u - v, here - v, here, here - u].map((cell) => vertexOf.get(cell));
          if (inside) triangles.push([a, b, c], [a, c, d]);
          else triangles.push([a, c, b], [a, d, c]);
        }
  return { positions, triangles };
}

const kCorners = /** @type {Point[]} */ (
  [0, 1, 2, 3, 4, 5, 6, 7].map((corner) => [corner & 1, (corner >> 1) & 1, corner >> 2])
);
const kEdges = kCorners.flatMap((from, a) =>
  [1, 2, 4].filter((bit) => (a & bit) === 0).map((bit) => [from, kCorners[a | bit]]),
);

/**
 * Returns the mean point where the surface crosses a cell's edges, in cells; undefined if it does not cross.
 * @param {(i: number, j: number, k: number) => number} value
 */
function meanCrossing(value) {
  const sum = [0, 0, 0];
  let crossings = 0;
  for (const [from, to] of kEdges) {
    const [a, b] = [value(...from), value(...to)];
    if (a < 0 === b < 0) continue;
    crossings += 1;
    for (let axis = 0; axis < 3; axis += 1) sum[axis] += from[axis] + (a / (a - b)) * (to[axis] - from[axis]);
  }
  return crossings > 0 ? sum.map((value) => value / crossings) : undefined;
}
