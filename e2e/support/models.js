// SPDX-License-Identifier: GPL-3.0-or-later
// Model files for the tests, made by the generator of the samples.
import { plate, pyramid, saddle } from '../../web/samples/shapes.js';
import { writeStl } from '../../web/samples/stl.js';

/** @typedef {import('../../web/samples/solid.js').Mesh} Mesh */

/** @param {string} name @param {Uint8Array} bytes */
const asFile = (name, bytes) => ({ name, mimeType: 'model/stl', buffer: Buffer.from(bytes) });

export const saddleMesh = saddle(24);
export const saddleFile = asFile('my saddle.stl', writeStl(saddleMesh, 'test'));

/** A file that declares more triangles than it contains. */
export const truncatedFile = asFile('cut off.stl', writeStl(saddleMesh, 'test').subarray(0, 10_000));

/** Makes a file of a square plate, eleven times as wide as thick. @param {number} widthMm */
export function plateFile(widthMm) {
  const { positions, triangles } = plate();
  const scale = widthMm / 44;
  const scaled = positions.map(
    ([x, y, z]) => /** @type {[number, number, number]} */ ([x * scale, y * scale, z * scale]),
  );
  return asFile(`plate of ${widthMm} mm.stl`, writeStl({ positions: scaled, triangles }, 'test'));
}

const whole = pyramid();
/** A file without its base: four open edges. */
export const openFile = asFile('open.stl', writeStl({ ...whole, triangles: whole.triangles.slice(2) }, 'test'));
