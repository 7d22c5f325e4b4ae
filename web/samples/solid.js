// SPDX-License-Identifier: GPL-3.0-or-later
// Indexed triangle meshes, for the samples and for checks of the page's results.

/** @typedef {[number, number, number]} Point */
/** @typedef {[number, number, number]} Triangle  counter-clockwise from outside */
/** @typedef {{ positions: Point[], triangles: Triangle[] }} Mesh */

/**
 * Defects that keep a mesh from being a closed 2-manifold. All counts are 0 for a solid.
 * @typedef {{ openEdges: number, nonManifoldEdges: number, nonManifoldVertices: number, degenerateTriangles: number,
 *   volume: number, min: Point, max: Point }} SolidCheck
 */

/** @param {Point} a @param {Point} b @returns {Point} */
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** @param {Point} a @param {Point} b @returns {Point} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** @param {Point} a @param {Point} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/**
 * Returns the signed volume by the divergence theorem, with tetrahedra from the first vertex, which keeps the terms
 * small.
 * @param {Mesh} mesh
 */
export function volume(mesh) {
  const origin = mesh.positions[0] ?? [0, 0, 0];
  let sum = 0;
  for (const [a, b, c] of mesh.triangles) {
    const p = subtract(mesh.positions[a], origin);
    const q = subtract(mesh.positions[b], origin);
    const r = subtract(mesh.positions[c], origin);
    sum += dot(p, cross(q, r));
  }
  return sum / 6;
}

/**
 * Counts the occurrences of each directed edge. Vertex indices are below 2²⁶, so the key is an exact number.
 * @param {Triangle[]} triangles
 * @returns {Map<number, number>}
 */
function countDirectedEdges(triangles) {
  const counts = new Map();
  for (const corners of triangles) {
    for (let i = 0; i < 3; i += 1) {
      const key = edgeKey(corners[i], corners[(i + 1) % 3]);
      counts.set(key, (counts.get(key) ?? 0) + 1);
    }
  }
  return counts;
}

const kKeyBase = 2 ** 26;

/** @param {number} from @param {number} to */
const edgeKey = (from, to) => from * kKeyBase + to;

/**
 * Counts the vertices whose triangles do not form exactly one fan.
 * @param {Mesh} mesh
 */
function countNonManifoldVertices(mesh) {
  /** @type {Map<number, number>[]} */
  const next = mesh.positions.map(() => new Map());
  for (const [a, b, c] of mesh.triangles) {
    next[a].set(b, c);
    next[b].set(c, a);
    next[c].set(a, b);
  }
  let count = 0;
  for (const ring of next) {
    if (ring.size === 0) continue;
    const start = /** @type {number} */ (ring.keys().next().value);
    let at = ring.get(start);
    let steps = 1;
    while (at !== undefined && at !== start && steps <= ring.size) {
      at = ring.get(at);
      steps += 1;
    }
    if (at !== start || steps !== ring.size) count += 1;
  }
  return count;
}

/**
 * @param {Mesh} mesh
 * @returns {SolidCheck}
 */
export function checkSolid(mesh) {
  const edges = countDirectedEdges(mesh.triangles);
  let openEdges = 0;
  let nonManifoldEdges = 0;
  for (const [key, count] of edges) {
    const from = Math.floor(key / kKeyBase);
    const to = key % kKeyBase;
    if (count > 1) nonManifoldEdges += 1;
    if (!edges.has(edgeKey(to, from))) openEdges += 1;
  }
  const degenerateTriangles = mesh.triangles.filter(([a, b, c]) => {
    const p = mesh.positions[a];
    const normal = cross(subtract(mesh.positions[b], p), subtract(mesh.positions[c], p));
    return dot(normal, normal) === 0;
  }).length;
  const nonManifoldVertices = countNonManifoldVertices(mesh);
  return {
    openEdges,
    nonManifoldEdges,
    nonManifoldVertices,
    degenerateTriangles,
    volume: volume(mesh),
    ...bounds(mesh),
  };
}

/**
 * @param {Mesh} mesh
 * @returns {{ min: Point, max: Point }}
 */
export function bounds(mesh) {
  /** @type {Point} */ const min = [Infinity, Infinity, Infinity];
  /** @type {Point} */ const max = [-Infinity, -Infinity, -Infinity];
  for (const p of mesh.positions) {
    for (let i = 0; i < 3; i += 1) {
      min[i] = Math.min(min[i], p[i]);
      max[i] = Math.max(max[i], p[i]);
    }
  }
  return { min, max };
}

/**
 * Closes every boundary loop with a fan around its centroid. This suits holes that are small and nearly flat.
 * @param {Mesh} mesh
 * @returns {Mesh}
 */
export function fillHoles(mesh) {
  const edges = countDirectedEdges(mesh.triangles);
  /** @type {Map<number, number>} */ const boundary = new Map(); // in the direction of the missing triangles
  for (const key of edges.keys()) {
    const from = Math.floor(key / kKeyBase);
    const to = key % kKeyBase;
    if (!edges.has(edgeKey(to, from))) boundary.set(to, from);
  }
  const positions = [...mesh.positions];
  const triangles = [...mesh.triangles];
  while (boundary.size > 0) {
    const start = /** @type {number} */ (boundary.keys().next().value);
    const loop = [start];
    for (let at = boundary.get(start); at !== start; at = boundary.get(at)) {
      if (at === undefined || loop.length > boundary.size) throw new Error('The boundary is not a simple loop');
      loop.push(at);
    }
    loop.forEach((vertex) => boundary.delete(vertex));
    const centre = positions.length;
    const mean = (/** @type {number} */ axis) => loop.reduce((sum, v) => sum + positions[v][axis], 0) / loop.length;
    positions.push([mean(0), mean(1), mean(2)]);
    loop.forEach((vertex, i) => triangles.push([vertex, loop[(i + 1) % loop.length], centre]));
  }
  return { positions, triangles };
}

/**
 * Performs one step of Loop subdivision on a closed mesh [Loop 1987]: four triangles replace each.
 * @param {Mesh} mesh
 * @returns {Mesh}
 */
export function subdivide(mesh) {
  /** @type {Map<number, number>} */ const opposite = new Map();
  /** @type {Set<number>[]} */ const neighbours = mesh.positions.map(() => new Set());
  for (const corners of mesh.triangles) {
    for (let i = 0; i < 3; i += 1) {
      const [from, to, third] = [corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]];
      opposite.set(edgeKey(from, to), third);
      neighbours[from].add(to);
    }
  }
  const positions = mesh.positions.map((p, vertex) => {
    const ring = [...neighbours[vertex]];
    const n = ring.length;
    const beta = (5 / 8 - (3 / 8 + Math.cos((2 * Math.PI) / n) / 4) ** 2) / n;
    return weightedSum([
      [p, 1 - n * beta],
      ...ring.map((v) => /** @type {[Point, number]} */ ([mesh.positions[v], beta])),
    ]);
  });
  /** @type {Map<number, number>} */ const middles = new Map();
  const middle = (/** @type {number} */ a, /** @type {number} */ b) => {
    const key = edgeKey(Math.min(a, b), Math.max(a, b));
    let index = middles.get(key);
    if (index === undefined) {
      const c = /** @type {number} */ (opposite.get(edgeKey(a, b)));
      const d = /** @type {number} */ (opposite.get(edgeKey(b, a)));
      index = positions.length;
      positions.push(
        weightedSum([
          [mesh.positions[a], 3 / 8],
          [mesh.positions[b], 3 / 8],
          [mesh.positions[c], 1 / 8],
          [mesh.positions[d], 1 / 8],
        ]),
      );
      middles.set(key, index);
    }
    return index;
  };
  /** @type {Triangle[]} */ const triangles = [];
  for (const [a, b, c] of mesh.triangles) {
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    triangles.push([a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]);
  }
  return { positions, triangles };
}

/** @param {[Point, number][]} terms @returns {Point} */
function weightedSum(terms) {
  /** @type {Point} */ const sum = [0, 0, 0];
  for (const [p, weight] of terms) for (let i = 0; i < 3; i += 1) sum[i] += weight * p[i];
  return sum;
}
