// SPDX-License-Identifier: GPL-3.0-or-later
// Our own sample shapes, in mm, z up, standing on z = 0 if they can stand. Each is a closed solid.
import { blended, cone, ellipsoid, standing, surfaceNet } from './implicit.js';

/** @typedef {import('./solid.js').Mesh} Mesh */
/** @typedef {import('./solid.js').Point} Point */
/** @typedef {import('./solid.js').Triangle} Triangle */

/**
 * Makes a sphere of radius 48 mm with bumps of ±2.5 mm, from an icosahedron split `levels` times.
 * @param {number} levels
 * @returns {Mesh}
 */
export function bumpySphere(levels) {
  const { positions, triangles } = icosphere(levels);
  const bumpy = positions.map((p) => {
    const [x, y, z] = p.map((v) => 5 * v);
    const radius = 48 + 2.5 * Math.sin(x + 0.7) * Math.sin(y + 1.9) * Math.sin(z + 0.3);
    return /** @type {Point} */ (p.map((v) => radius * v));
  });
  return { positions: bumpy.map(([x, y, z]) => [x, y, z + 50]), triangles };
}

/** @param {number} levels @returns {Mesh} */
function icosphere(levels) {
  const g = (1 + Math.sqrt(5)) / 2;
  /** @type {Point[]} */
  const positions = [
    [-1, g, 0],
    [1, g, 0],
    [-1, -g, 0],
    [1, -g, 0],
    [0, -1, g],
    [0, 1, g],
    [0, -1, -g],
    [0, 1, -g],
    [g, 0, -1],
    [g, 0, 1],
    [-g, 0, -1],
    [-g, 0, 1],
  ];
  /** @type {Triangle[]} */
  let triangles = [
    [0, 11, 5],
    [0, 5, 1],
    [0, 1, 7],
    [0, 7, 10],
    [0, 10, 11],
    [1, 5, 9],
    [5, 11, 4],
    [11, 10, 2],
    [10, 7, 6],
    [7, 1, 8],
    [3, 9, 4],
    [3, 4, 2],
    [3, 2, 6],
    [3, 6, 8],
    [3, 8, 9],
    [4, 9, 5],
    [2, 4, 11],
    [6, 2, 10],
    [8, 6, 7],
    [9, 8, 1],
  ];
  for (let level = 0; level < levels; level += 1) {
    /** @type {Map<string, number>} */ const middles = new Map();
    const middle = (/** @type {number} */ a, /** @type {number} */ b) => {
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      const known = middles.get(key);
      if (known !== undefined) return known;
      const [p, q] = [positions[a], positions[b]];
      middles.set(key, positions.length);
      return positions.push([(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2]) - 1;
    };
    triangles = triangles.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
      return /** @type {Triangle[]} */ ([
        [a, ab, ca],
        [ab, b, bc],
        [ca, bc, c],
        [ab, bc, ca],
      ]);
    });
  }
  return { positions: positions.map((p) => /** @type {Point} */ (p.map((v) => v / Math.hypot(...p)))), triangles };
}

/**
 * Makes a vase 120 mm high with a wall of 6 mm and a floor of 6 mm, turned from a profile.
 * @param {number} segments  around the axis
 * @param {number} rows      along the outside
 * @returns {Mesh}
 */
export function vase(segments, rows) {
  const height = 120;
  const wall = 6;
  const outer = (/** @type {number} */ z) => 34 + 12 * Math.sin((Math.PI * z) / 95 + 0.1);
  /** @type {[number, number][]} */ const profile = []; // (radius, z), from the axis at the bottom to the axis inside
  for (let i = 0; i <= rows; i += 1) profile.push([outer((height * i) / rows), (height * i) / rows]);
  for (let i = rows; i >= 0; i -= 1) {
    const z = wall + ((height - wall) * i) / rows;
    profile.push([outer(z) - wall, z]);
  }
  return revolve(profile, segments);
}

/**
 * Makes a chess pawn 114 mm high: a turned foot, a waist, a collar, and a ball of radius 28 mm as its head.
 * @param {number} segments  around the axis
 * @returns {Mesh}
 */
export function pawn(segments) {
  /** @type {[number, number][]} */ const profile = [];
  const arc = (
    /** @type {[number, number]} */ [radius, z],
    /** @type {number} */ size,
    /** @type {number} */ from,
    /** @type {number} */ to,
    /** @type {number} */ steps,
  ) => {
    for (let i = 0; i <= steps; i += 1) {
      const angle = (Math.PI / 180) * (from + ((to - from) * i) / steps);
      profile.push([radius + size * Math.cos(angle), z + size * Math.sin(angle)]);
    }
  };
  profile.push([42, 0]);
  arc([36, 7], 7, -60, 75, 12);
  arc([52, 38], 32, 228, 158, 24); // the hollow waist
  arc([24, 53], 4, -70, 90, 8);
  arc([0, 86], 28, -57, 89, 60);
  return revolve(profile, segments);
}

/**
 * Makes an owl 113 mm high: a body, a head with tufts, eyes and a beak, wings and feet, blended.
 * @param {number} cellMm  of the grid for meshing
 * @returns {Mesh}
 */
export function owl(cellMm) {
  const pair = (/** @type {(side: number) => import('./implicit.js').Distance} */ part) => [part(-1), part(1)];
  const body = blended(12, ellipsoid([0, 0, 40], [33, 29, 44]), ellipsoid([0, -1, 82], [30, 26, 24]));
  const wings = pair((side) => ellipsoid([side * 29, 6, 42], [8, 20, 32]));
  const tufts = pair((side) => cone([side * 17, 0, 98], [side * 24, 2, 110], 7, 3));
  const feet = pair((side) => ellipsoid([side * 12, -22, 3], [9, 12, 7]));
  const eyes = pair((side) => ellipsoid([side * 11, -23, 87], [9.5, 7, 9.5]));
  const beak = cone([0, -26, 80], [0, -31, 75], 4.5, 2);
  const solid = standing(blended(5, blended(6, body, ...wings, ...tufts, ...feet), ...eyes, beak));
  return surfaceNet(solid, [-42, -42, (-3 * cellMm) / 2], [42, 36, 118], cellMm);
}

/**
 * @param {[number, number][]} profile  (radius > 0, z) from bottom outside to inside; closed with a point on the axis
 *   at both ends
 * @param {number} segments
 * @returns {Mesh}
 */
function revolve(profile, segments) {
  /** @type {Point[]} */ const positions = [];
  for (const [radius, z] of profile) {
    for (let k = 0; k < segments; k += 1) {
      const angle = (2 * Math.PI * k) / segments;
      positions.push([radius * Math.cos(angle), radius * Math.sin(angle), z]);
    }
  }
  const last = profile.length - 1;
  const below = positions.push([0, 0, profile[0][1]]) - 1;
  const inside = positions.push([0, 0, profile[last][1]]) - 1;
  /** @type {Triangle[]} */ const triangles = [];
  for (let k = 0; k < segments; k += 1) {
    const next = (k + 1) % segments;
    triangles.push([below, next, k], [inside, last * segments + k, last * segments + next]);
    for (let row = 0; row < last; row += 1) {
      const [a, b] = [row * segments + k, row * segments + next];
      const [c, d] = [a + segments, b + segments];
      triangles.push([a, b, d], [a, d, c]);
    }
  }
  return { positions, triangles };
}

/**
 * Makes a five-pointed star with a ridge to every point: 20 large triangles, two apexes.
 * @returns {Mesh}
 */
export function star() {
  /** @type {Point[]} */ const positions = [
    [0, 0, 40],
    [0, 0, 0],
  ];
  for (let k = 0; k < 10; k += 1) {
    const radius = k % 2 === 0 ? 70 : 45;
    const angle = Math.PI / 2 + (Math.PI * k) / 5;
    positions.push([radius * Math.cos(angle), radius * Math.sin(angle), 20]);
  }
  /** @type {Triangle[]} */ const triangles = [];
  for (let k = 0; k < 10; k += 1) {
    const [a, b] = [2 + k, 2 + ((k + 1) % 10)];
    triangles.push([0, a, b], [1, b, a]);
  }
  return { positions, triangles };
}

/**
 * Makes a plate of 44 × 44 × 4 mm for testing a printer.
 * @returns {Mesh}
 */
export function plate() {
  const [half, height] = [22, 4];
  /** @type {Point[]} */
  const positions = [0, height].flatMap(
    (z) =>
      /** @type {Point[]} */ ([
        [-half, -half, z],
        [half, -half, z],
        [half, half, z],
        [-half, half, z],
      ]),
  );
  const sides = [0, 1, 2, 3].flatMap((k) => {
    const next = (k + 1) % 4;
    return /** @type {Triangle[]} */ ([
      [k, next, 4 + next],
      [k, 4 + next, 4 + k],
    ]);
  });
  return { positions, triangles: [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], ...sides] };
}

/**
 * Makes a pyramid of six triangles: base 120 × 120 mm, 80 mm high.
 * @returns {Mesh}
 */
export function pyramid() {
  return {
    positions: [
      [-60, -60, 0],
      [60, -60, 0],
      [60, 60, 0],
      [-60, 60, 0],
      [0, 0, 80],
    ],
    triangles: [
      [0, 2, 1],
      [0, 3, 2],
      [0, 1, 4],
      [1, 2, 4],
      [2, 3, 4],
      [3, 0, 4],
    ],
  };
}

/**
 * Makes a block of 90 × 90 mm whose top is a hyperbolic paraboloid, ±10 mm about 30 mm.
 * @param {number} cells  along an edge
 * @returns {Mesh}
 */
export function saddle(cells) {
  const side = 90;
  const columns = cells + 1;
  /** @type {Point[]} */ const positions = [];
  for (const top of [1, 0]) {
    for (let j = 0; j <= cells; j += 1) {
      for (let i = 0; i <= cells; i += 1) {
        const [u, v] = [(2 * i) / cells - 1, (2 * j) / cells - 1];
        positions.push([(side / 2) * u, (side / 2) * v, top * (30 + 10 * (u * u - v * v))]);
      }
    }
  }
  const below = columns * columns;
  /** @type {Triangle[]} */ const triangles = [];
  const quad = (/** @type {number[]} */ [a, b, c, d]) => triangles.push([a, b, c], [a, c, d]);
  for (let j = 0; j < cells; j += 1) {
    for (let i = 0; i < cells; i += 1) {
      const a = j * columns + i;
      const [b, c, d] = [a + 1, a + 1 + columns, a + columns];
      quad([a, b, c, d]);
      quad([below + a, below + d, below + c, below + b]);
    }
  }
  for (let k = 0; k < cells; k += 1) {
    const far = cells * columns;
    /** @type {[number, number][]} */ // each border edge of the top, counter-clockwise seen from above
    const border = [
      [k, k + 1],
      [k * columns + cells, (k + 1) * columns + cells],
      [far + k + 1, far + k],
      [(k + 1) * columns, k * columns],
    ];
    for (const [p, q] of border) quad([q, p, below + p, below + q]);
  }
  return { positions, triangles };
}
