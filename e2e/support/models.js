// SPDX-License-Identifier: GPL-3.0-or-later
// Model files for the tests, made by the generator of the samples.
import { pyramid, saddle } from '../../web/samples/shapes.js';
import { writeStl } from '../../web/samples/stl.js';

/** @typedef {import('../../web/samples/solid.js').Mesh} Mesh */

/** @param {string} name @param {Uint8Array} bytes */
const asFile = (name, bytes) => ({ name, mimeType: 'model/stl', buffer: Buffer.from(bytes) });

export const saddleMesh = saddle(24);
export const saddleFile = asFile('my saddle.stl', writeStl(saddleMesh, 'test'));

/** A file that declares more triangles than it contains. */
export const truncatedFile = asFile('cut off.stl', writeStl(saddleMesh, 'test').subarray(0, 10_000));

const whole = pyramid();
/** A file without its base: four open edges. */
export const openFile = asFile('open.stl', writeStl({ ...whole, triangles: whole.triangles.slice(2) }, 'test'));
