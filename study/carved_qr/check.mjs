// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the truth of CarvedQR against its pictures. In each picture, the middles of the matrix's dark modules must be
// darker than the middles of its light modules, at the positions that the corners give, and by less at positions one
// module further on. Leaves out tilted pictures: in these a curved surface is no plane between its corners.
//
//     node check.mjs FOLDER PEERS        PEERS: the folder in which the npm packages are installed
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { readPicture } from '../decoders.mjs';

const [folder, peers] = process.argv.slice(2);

/**
 * Returns the projective map of the unit square to a quadrilateral, corners clockwise from the top left [Heckbert
 * 1989].
 * @param {[number, number][]} corners
 * @returns {(u: number, v: number) => [number, number]}
 */
function ontoCorners([[x0, y0], [x1, y1], [x2, y2], [x3, y3]]) {
  const [dx1, dx2, sx] = [x1 - x2, x3 - x2, x0 - x1 + x2 - x3],
    [dy1, dy2, sy] = [y1 - y2, y3 - y2, y0 - y1 + y2 - y3];
  const det = dx1 * dy2 - dx2 * dy1,
    g = (sx * dy2 - dx2 * sy) / det,
    h = (dx1 * sy - sx * dy1) / det;
  const [a, b, d, e] = [x1 - x0 + g * x1, x3 - x0 + h * x3, y1 - y0 + g * y1, y3 - y0 + h * y3];
  return (u, v) => [(a * u + b * v + x0) / (g * u + h * v + 1), (d * u + e * v + y0) / (g * u + h * v + 1)];
}

/** Returns how much darker the dark modules are on average, 0 … 255, sampled `off` modules to the right. */
function contrastOf(line, picture, /** @type {number} */ off) {
  const at = ontoCorners(line.corners),
    size = line.matrix.length,
    sums = [0, 0],
    counts = [0, 0];
  for (let row = 0; row < size; row += 1) {
    for (let column = 0; column < size; column += 1) {
      const [x, y] = at((column + 0.5 + off) / size, (row + 0.5) / size).map(Math.floor);
      if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) continue;
      const dark = Number(line.matrix[row][column]);
      sums[dark] += picture.grey[y * picture.width + x];
      counts[dark] += 1;
    }
  }
  return sums[0] / counts[0] - sums[1] / counts[1];
}

const kMostTiltDeg = 10;
const parts = existsSync(`${folder}/truth`) ? readdirSync(`${folder}/truth`) : [];
const lines = parts
  .flatMap((part) => readFileSync(`${folder}/truth/${part}`, 'utf8').split('\n').filter(Boolean))
  .map((line) => JSON.parse(line))
  .filter((line) => line.tiltDeg <= kMostTiltDeg);
const wrong = lines.filter((line) => {
  const picture = readPicture(peers, `${folder}/pictures/${line.picture}`);
  const contrast = contrastOf(line, picture, 0);
  return contrast <= 0 || contrast <= contrastOf(line, picture, 1);
});
for (const line of wrong) console.error(`${line.picture}: its truth does not fit`);
console.log(`${lines.length} pictures from in front, the truth of ${lines.length - wrong.length} fits`);
process.exitCode = lines.length > 0 && wrong.length === 0 ? 0 : 1;
