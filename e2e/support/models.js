// SPDX-License-Identifier: GPL-3.0-or-later
// Model files for the tests, made by the samples' generator.
import { pyramid, saddle } from '../../web/samples/shapes.js';
import { writeStl } from '../../web/samples/stl.js';

/** @typedef {import('../../web/samples/solid.js').Mesh} Mesh */

/** @param {string} name @param {Uint8Array} bytes */
const asFile = (name, bytes) => ({ name, mimeType: 'model/stl', buffer: Buffer.from(bytes) });

export const saddleMesh = saddle(24);
export const saddleFile = asFile('my saddle.stl', writeStl(saddleMesh, 'test'));

/** Its count says more triangles than there are. */
export const truncatedFile = asFile('cut off.stl', writeStl(saddleMesh, 'test').subarray(0, 10_000));

const whole = pyramid();
/** Three edges are open. */
export const openFile = asFile('open.stl', writeStl({ ...whole, triangles: whole.triangles.slice(1) }, 'test'));
