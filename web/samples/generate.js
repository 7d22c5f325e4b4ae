// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the sample models and their manifest into public/samples/: `npm run samples`.
import { mkdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
import { bumpySphere, owl, pawn, plate, pyramid, saddle, star, vase } from './shapes.js';
import { bounds, fillHoles, subdivide } from './solid.js';
import { writeStl } from './stl.js';

/** @typedef {import('./solid.js').Mesh} Mesh */
/** @typedef {import('./solid.js').Point} Point */
/** @typedef {import('./solid.js').Triangle} Triangle */

const kOwnCredit = 'Made by QRelief; CC0.';

const kStepsPerMm = 1024; // of the bunny's coordinates, much finer than the scan; floats of so few digits compress

/**
 * Returns the bunny of the npm package, the reduced Stanford scan (y up, with holes in its base), closed, smoothed by
 * one step of subdivision, z up, 100 mm high. The page loads it at first, so its file has to compress well.
 * @returns {Mesh}
 */
function stanfordBunny() {
  const source = createRequire(import.meta.url)('bunny');
  const turned = {
    positions: source.positions.map((/** @type {Point} */ [x, y, z]) => [x, -z, y]),
    triangles: source.cells,
  };
  const closed = subdivide(fillHoles(turned));
  const { min, max } = bounds(closed);
  const scale = 100 / (max[2] - min[2]);
  const inMm = (/** @type {number} */ x) => Math.round(x * scale * kStepsPerMm) / kStepsPerMm;
  const positions = closed.positions.map(
    ([x, y, z]) =>
      /** @type {Point} */ ([inMm(x - (min[0] + max[0]) / 2), inMm(y - (min[1] + max[1]) / 2), inMm(z - min[2])]),
  );
  return inPackingOrder({ positions, triangles: closed.triangles });
}

/**
 * Orders triangles from the bottom to the top, so that neighbours are near each other in the file, and begins each at
 * the corner that came first.
 * @param {Mesh} mesh
 * @returns {Mesh}
 */
function inPackingOrder({ positions, triangles }) {
  const topOf = (/** @type {Triangle} */ corners) => Math.max(...corners.map((corner) => positions[corner][2]));
  const sorted = triangles.toSorted((a, b) => topOf(a) - topOf(b));
  const order = new Map([...new Set(sorted.flat())].map((corner, at) => [corner, at]));
  const turned = sorted.map((corners) => {
    const places = corners.map((corner) => order.get(corner) ?? 0);
    const first = places.indexOf(Math.min(...places));
    return /** @type {Triangle} */ ([...corners.slice(first), ...corners.slice(0, first)]);
  });
  return { positions, triangles: turned };
}

/**
 * The samples. `centreMm` is a point on or very near the surface where a code fits well.
 * @type {{ id: string, name: string, mesh: Mesh, centreMm: Point, credit: string }[]}
 */
export const samples = [
  {
    id: 'bunny',
    name: 'Stanford bunny',
    mesh: stanfordBunny(),
    centreMm: [6.3, -36.2, 41.1],
    credit:
      'Stanford 3D Scanning Repository, by way of the npm package “bunny” (public domain); holes closed, ' +
      'subdivided once.',
  },
  { id: 'owl', name: 'Owl', mesh: owl(1.8), centreMm: [0, -30, 38], credit: kOwnCredit },
  { id: 'pawn', name: 'Chess pawn', mesh: pawn(96), centreMm: [0, -28, 86], credit: kOwnCredit },
  { id: 'bumpy-sphere', name: 'Bumpy sphere', mesh: bumpySphere(5), centreMm: [0, -48, 50], credit: kOwnCredit },
  { id: 'vase', name: 'Vase', mesh: vase(144, 60), centreMm: [0, -46, 50], credit: kOwnCredit },
  { id: 'star', name: 'Star', mesh: star(), centreMm: [0, 0, 40], credit: kOwnCredit },
  { id: 'pyramid', name: 'Pyramid', mesh: pyramid(), centreMm: [0, -33, 36], credit: kOwnCredit },
  { id: 'saddle', name: 'Saddle', mesh: saddle(48), centreMm: [0, 0, 30], credit: kOwnCredit },
  { id: 'plate', name: 'Test plate', mesh: plate(), centreMm: [0, 0, 4], credit: kOwnCredit },
];

/** Writes every sample and `manifest.json` into `folder`. @param {string} folder */
export function writeSamples(folder) {
  mkdirSync(folder, { recursive: true });
  const manifest = samples.map(({ id, name, mesh, centreMm, credit }) => {
    const file = `${id}.stl`;
    writeFileSync(`${folder}/${file}`, writeStl(mesh, `QRelief sample: ${name}`));
    return { id, name, file, centreMm, credit };
  });
  writeFileSync(`${folder}/manifest.json`, `${JSON.stringify(manifest, null, 2)}\n`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  writeSamples(fileURLToPath(new URL('../../public/samples', import.meta.url)));
}
