// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of the view cube as the camera sees them, without perspective.

/** @typedef {import('../engine/types.js').StandardView} StandardView */
/** @typedef {[number, number, number]} Vector */
/**
 * @typedef {{ name: StandardView, facing: number, matrix: number[] }} CubeFace  `matrix`: the SVG transform from the
 *   face's square (-1 … 1, x to the right, y downwards) to the screen
 */

/**
 * Each face's normal, and its right and up directions as seen from outside.
 * @type {[StandardView, Vector, Vector, Vector][]}
 */
const kFaces = [
  ['front', [0, -1, 0], [1, 0, 0], [0, 0, 1]],
  ['back', [0, 1, 0], [-1, 0, 0], [0, 0, 1]],
  ['left', [-1, 0, 0], [0, -1, 0], [0, 0, 1]],
  ['right', [1, 0, 0], [0, 1, 0], [0, 0, 1]],
  ['top', [0, 0, 1], [1, 0, 0], [0, 1, 0]],
  ['bottom', [0, 0, -1], [1, 0, 0], [0, -1, 0]],
];
const kLeastFacing = 0.02;

/** @param {number[]} a @param {number[]} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/**
 * Returns the visible faces, starting with the face that faces the camera most.
 * @param {number[][]} axes  the camera's right, up and back, z up
 * @param {number} halfEdge  px
 * @returns {CubeFace[]}
 */
export function visibleFaces([right, up, back], halfEdge) {
  const onScreen = (/** @type {number[]} */ v) => [dot(v, right) * halfEdge, -dot(v, up) * halfEdge];
  return kFaces
    .map(([name, normal, faceRight, faceUp]) => ({
      name,
      facing: dot(normal, back),
      matrix: [...onScreen(faceRight), ...onScreen(faceUp).map((v) => -v), ...onScreen(normal)],
    }))
    .filter(({ facing }) => facing > kLeastFacing)
    .sort((a, b) => b.facing - a.facing);
}
