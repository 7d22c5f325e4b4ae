// SPDX-License-Identifier: GPL-3.0-or-later
// Compares files before and after an engraving.
import { execFile } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { promisify } from 'node:util';
import { read3mf, worldCorners } from './readers.mjs';
import { welded } from './solidity.mjs';

/** @typedef {import('./readers.mjs').FileBody} FileBody */
/** @typedef {import('./solids.mjs').Point} Point */

export const INLAY = 'QR code'; // the inlay's name

const run = promisify(execFile);

/** Returns the corners of each triangle as 32-bit floats. @param {FileBody} body */
function cornersOf(body) {
  const corners = worldCorners(body).map((p) => p.map(Math.fround).join(' '));
  return body.mesh.triangles.map((triangle) => triangle.map((v) => corners[v]).join(', '));
}

/**
 * Returns the first difference between a body before and after; empty if there is none.
 * @param {FileBody} before
 * @param {FileBody} after
 * @param {boolean} isCarved  its triangles must differ instead
 */
export function firstDifference(before, after, isCarved) {
  for (const key of /** @type {const} */ (['name', 'object', 'extruder', 'isModel'])) {
    if (before[key] !== '' && before[key] !== after[key]) return `${key} "${before[key]}" became "${after[key]}"`;
  }
  const [was, is] = [cornersOf(before), cornersOf(after)];
  const at = was.findIndex((corners, t) => corners !== is[t]);
  const isSame = at < 0 && was.length === is.length;
  if (isCarved) return isSame ? 'its triangles did not change' : '';
  if (!isSame)
    return `${was.length} triangles became ${is.length}; the first that differs is ${at}: (${was[at]}) became (${is[at]})`;
  if (before.paint.join() !== after.paint.join() && before.transforms !== '') return 'its paint changed';
  return '';
}

/**
 * Splits the triangles of a file that keeps no bodies apart: those of the other bodies come in their order, and all
 * others are of the carved body.
 * @param {FileBody[]} before
 * @param {FileBody[]} after
 * @param {number} carved  index of a body
 * @returns {FileBody[] | string}  or what is wrong
 */
export function splitShells(before, after, carved) {
  /** @type {Map<string, number>} */ const bodyOf = new Map();
  before.forEach((body, i) => {
    if (i !== carved) for (const corners of cornersOf(body)) bodyOf.set(corners, i);
  });
  const split = before.map((body) => ({
    ...body,
    mesh: { positions: /** @type {Point[]} */ ([]), triangles: /** @type {Point[]} */ ([]) },
  }));
  for (const body of after) {
    cornersOf(body).forEach((corners, t) => {
      const { positions, triangles } = split[bodyOf.get(corners) ?? carved].mesh;
      triangles.push([positions.length, positions.length + 1, positions.length + 2]);
      positions.push(...body.mesh.triangles[t].map((v) => body.mesh.positions[v]));
    });
  }
  for (const body of split) body.mesh = welded(body.mesh);
  return split;
}

/** Opens a file in PrusaSlicer and saves it again. @param {string} file */
async function asOpened(file) {
  const saved = file.replace('.3mf', '-opened.3mf');
  const { stdout } = await run('prusa-slicer', ['--info', '--export-3mf', '--output', saved, file]);
  return { bodies: read3mf(readFileSync(saved)), isManifold: !stdout.includes('manifold = no') };
}

/**
 * Returns what PrusaSlicer opens in another way than before.
 * @param {string} input
 * @param {string} output
 */
export async function opened(input, output) {
  const [before, after] = [await asOpened(input), await asOpened(output)];
  const inlay = read3mf(readFileSync(output)).findIndex(({ name }) => name === INLAY);
  // PrusaSlicer names bodies without a name after the file and a number.
  const list = (/** @type {FileBody[]} */ bodies) =>
    bodies.map(
      ({ name, object, isModel, extruder }) =>
        [object, name].map((text) => text.replace(/^\d+-.*_\d+$/, '-')).join(', ') +
        (isModel ? '' : ', no model') +
        (extruder ? `, extruder ${extruder}` : ''),
    );
  const [was, is] = [list(before.bodies), list(after.bodies)];
  if (inlay >= 0) is.splice(inlay, 1);
  // An inlay in a file without settings gives both bodies of its object an extruder.
  const isSame = was.length === is.length && was.every((text, i) => is[i].startsWith(text));
  return [
    ...(before.isManifold && !after.isManifold ? ['PrusaSlicer: not manifold any more'] : []),
    ...(isSame ? [] : [`PrusaSlicer: opened as\n${is.join('\n')}\ninstead of\n${was.join('\n')}`]),
  ];
}
