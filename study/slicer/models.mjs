// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks with one flat face for a code, as ASCII STL, in the middle of a plate.

/** @typedef {[number, number, number]} Point */
/** @typedef {{ name: string, corners: Point[], centre: Point, normal: Point }} Block */

const SIDE = 64; // mm, of the face with the code
const THICK = 8; // mm
const MIDDLE = 105; // of the plate, x and y

/**
 * Returns a block whose face with the code leans by an angle: 0 faces up, 90 stands upright and faces -y.
 * @param {string} name
 * @param {number} degrees
 * @returns {Block}
 */
function leaning(name, degrees) {
  const [sine, cosine] = [Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180)];
  // The outline in the plane of y and z: the face with the code from its lower to its upper edge, then the plate.
  const [back, up] = [SIDE * cosine, SIDE * sine];
  /** @type {[number, number][]} */
  const outline =
    degrees === 0
      ? [[0, THICK], [SIDE, THICK], [SIDE, 0], [0, 0]] // prettier-ignore
      : [[0, 0], [back, up], [back + THICK, up], [back + THICK, 0]]; // prettier-ignore
  const depth = Math.max(...outline.map(([y]) => y));
  /** @type {(x: number, point: [number, number]) => Point} */
  const at = (x, [y, z]) => [MIDDLE - SIDE / 2 + x, MIDDLE - depth / 2 + y, z];
  const corners = [...outline.map((point) => at(0, point)), ...outline.map((point) => at(SIDE, point))];
  const [a, b] = [at(SIDE / 2, outline[0]), at(SIDE / 2, outline[1])];
  /** @type {Point} */
  const centre = [a[0], (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
  return { name, corners, centre, normal: [0, -sine, cosine] };
}

/** @type {Block[]} */
export const blocks = [leaning('up', 0), leaning('slanted', 50), leaning('upright', 90)];

/**
 * Writes a block: two ends of four corners each, and four sides between them.
 * @param {Block} block
 */
export function stl({ corners }) {
  const triangles = [[0, 1, 2], [0, 2, 3], [4, 6, 5], [4, 7, 6]]; // prettier-ignore
  for (let i = 0; i < 4; i += 1) {
    const next = (i + 1) % 4;
    triangles.push([i, i + 4, next], [next, i + 4, next + 4]);
  }
  const facets = triangles.map(
    (corner) =>
      `facet normal 0 0 0\nouter loop\n${corner.map((i) => `vertex ${corners[i].join(' ')}\n`).join('')}endloop\nendfacet\n`,
  );
  return `solid block\n${facets.join('')}endsolid block\n`;
}
