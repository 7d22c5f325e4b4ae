// SPDX-License-Identifier: GPL-3.0-or-later
// Makes scenes of 2 to 6 closed bodies that touch, overlap, lie within each other or apart, from a seed.
import { box, hollowed, moved, pocketed, prism, sphere } from './solids.mjs';

/** @typedef {import('./solids.mjs').Point} Point */
/** @typedef {import('./solids.mjs').Mesh} Mesh */
/** @typedef {{ name: string, extruder: number, mesh: Mesh, min: Point, max: Point, relation: string }} SceneBody */
/** @typedef {() => number} Random a number from 0 to 1, without 1 */

const STEP = 1 / 8; // mm; all contacts lie on multiples of it
const LARGE = { least: 20, most: 36 }; // mm, width and depth of the body that can carry a code
const SMALL = { least: 2, most: 14 };
const LOW = { least: 1, most: 6 };

/** Returns the random numbers of a seed: mulberry32 by Tommy Ettinger. @param {number} seed @returns {Random} */
export function randomOf(seed) {
  let state = (seed * 0x9e3779b9) >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Returns a random element. @template T @param {Random} random @param {readonly T[]} list @returns {T} */
export const oneOf = (random, list) => list[Math.floor(random() * list.length)];

/** Returns a random multiple of the step, both bounds included. @param {Random} random @param {number} least @param {number} most */
function between(random, least, most) {
  const steps = Math.max(0, Math.round((most - least) / STEP));
  return least + STEP * Math.floor(random() * (steps + 1));
}

/** Returns a random shape of a size. @param {Random} random @param {Point} size @param {boolean} isFlat  it has a flat top @returns {Mesh} */
function shapeOf(random, size, isFlat) {
  const kind = oneOf(random, ['box', 'box', 'prism', 'cylinder', 'hollow', ...(isFlat ? [] : ['sphere'])]);
  if (kind === 'prism') return prism(size, 5 + Math.floor(random() * 4));
  if (kind === 'cylinder') return prism(size, 24);
  if (kind === 'sphere') return sphere(size);
  if (kind === 'hollow' && Math.min(...size) >= 3) {
    const hollow = /** @type {Point} */ (size.map((x) => x - 2));
    return hollowed(box(size), moved(box(hollow), [1, 1, 1]));
  }
  return box(size);
}

/** Ways in which a new body lies to an older one: its least corner. @type {Record<string, (random: Random, old: SceneBody, size: Point) => Point>} */
const RELATIONS = {
  'face above': (random, old, size) => [along(random, old, size, 0), along(random, old, size, 1), old.max[2]],
  'face beside': (random, old, size) => [old.max[0], along(random, old, size, 1), along(random, old, size, 2)],
  edge: (random, old, size) => [old.max[0], along(random, old, size, 1), old.max[2]],
  'same edge': (_, old) => [old.max[0], old.min[1], old.max[2]],
  corner: (_, old) => [old.max[0], old.max[1], old.max[2]],
  overlapping: (random, old, size) => [
    along(random, old, size, 0),
    along(random, old, size, 1),
    old.max[2] - between(random, STEP, Math.max(STEP, size[2] - STEP)),
  ],
  flush: (random, old, size) => [along(random, old, size, 0), along(random, old, size, 1), old.max[2] - size[2]],
  apart: (random, old) => [old.max[0] + between(random, STEP, 8), old.min[1], old.min[2]],
};

/** Returns a least coordinate with which the new body shares a stretch of an axis with the old one. @param {Random} random @param {SceneBody} old @param {Point} size @param {number} axis */
function along(random, old, size, axis) {
  return between(random, old.min[axis] - size[axis] + STEP, old.max[axis] - STEP);
}

/** @param {Random} random @param {{ least: number, most: number }} wide @param {{ least: number, most: number }} high @returns {Point} */
const sizeOf = (random, wide, high) => [
  between(random, wide.least, wide.most),
  between(random, wide.least, wide.most),
  between(random, high.least, high.most),
];

/** Returns the bodies of a seed. @param {number} seed @returns {SceneBody[]} */
export function sceneOf(seed) {
  const random = randomOf(seed);
  const count = 2 + Math.floor(random() * 5);
  /** @type {SceneBody[]} */ const bodies = [];
  const add = (/** @type {Mesh} */ mesh, /** @type {Point} */ at, /** @type {string} */ relation) => {
    const placed = moved(mesh, at);
    const bound = (/** @type {(...x: number[]) => number} */ of) =>
      /** @type {Point} */ ([0, 1, 2].map((k) => of(...placed.positions.map((p) => p[k]))));
    const [min, max] = [bound(Math.min), bound(Math.max)];
    const extruder = 1 + Math.floor(random() * 4);
    bodies.push({ name: `body ${bodies.length + 1}`, extruder, mesh: placed, min, max, relation });
  };
  const size = sizeOf(random, LARGE, { least: 3, most: 8 });
  if (random() < 0.2) {
    /** @type {Point} */ const pocket = [
      between(random, 4, size[0] - 2),
      between(random, 4, size[1] - 2),
      between(random, 1, 2),
    ];
    /** @type {Point} */ const at = [STEP * 8, STEP * 8, size[2] - pocket[2]];
    add(pocketed(size, pocket, at), [0, 0, 0], 'with a pocket');
    add(box(pocket), at, 'in the pocket');
  } else {
    add(shapeOf(random, size, true), [0, 0, 0], 'first');
  }
  while (bodies.length < count) {
    const old = oneOf(random, bodies);
    const relation = oneOf(random, ['nested', ...Object.keys(RELATIONS)]);
    if (relation === 'nested') {
      const inside = /** @type {Point} */ (
        [0, 1, 2].map((k) => between(random, STEP, Math.max(STEP, old.max[k] - old.min[k] - 2 * STEP)))
      );
      const at = /** @type {Point} */ (
        [0, 1, 2].map((k) =>
          between(random, old.min[k] + STEP, Math.max(old.min[k] + STEP, old.max[k] - inside[k] - STEP)),
        )
      );
      add(box(inside), at, `within ${old.name}`);
      continue;
    }
    const own = sizeOf(random, random() < 0.2 ? LARGE : SMALL, LOW);
    add(shapeOf(random, own, false), RELATIONS[relation](random, old, own), `${relation} of ${old.name}`);
  }
  return bodies;
}
