// SPDX-License-Identifier: GPL-3.0-or-later
// Subtracts the pockets of bench/carving_stage.cpp with manifold-3d and prints both sides as a table:
//     node bench/carving_peer.mjs FOLDER PATH_OF_MANIFOLD_JS
import { readFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const RUNS = 7;
const [folder, library] = process.argv.slice(2);
const { default: load } = await import(pathToFileURL(resolve(library)).href);
const peer = await load();
peer.setup();

/** @param {string} path */
function readMesh(path) {
  const bytes = (/** @type {string} */ kind) => new Uint8Array(readFileSync(`${path}.${kind}`)).buffer;
  return { numProp: 3, vertProperties: new Float32Array(bytes('xyz')), triVerts: new Uint32Array(bytes('tri')) };
}

/** @param {number[]} values */
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

/** @param {string} name */
function subtract(name) {
  const model = readMesh(join(folder, `${name}.model`));
  const pockets = readMesh(join(folder, `${name}.pockets`));
  const taking = [];
  const subtracting = [];
  let triangles = 0;
  let volume = 0;
  for (let run = 0; run < RUNS; ++run) {
    const start = performance.now();
    const solid = new peer.Manifold(new peer.Mesh(model));
    solid.numTri();
    const taken = performance.now();
    const tool = new peer.Manifold(new peer.Mesh(pockets));
    const toolStatus = tool.status();
    if (toolStatus !== 'NoError') throw new Error(`${name}: the pockets are no manifold: ${toolStatus}`);
    const begun = performance.now();
    const carved = solid.subtract(tool);
    triangles = carved.numTri();
    carved.getMesh();
    subtracting.push(performance.now() - begun);
    taking.push(taken - start);
    volume = carved.volume();
    for (const body of [solid, tool, carved]) body.delete();
  }
  return { takeMs: median(taking), ms: median(subtracting), triangles, volume };
}

const cases = JSON.parse(readFileSync(join(folder, 'cases.json'), 'utf8'));
console.log(
  '| model | triangles | pattern | ours ms (resampled) | manifold-3d ms (taking in) | ratio | ' +
    'ours triangles (resampled) | manifold-3d triangles | volume lost: ours, manifold-3d mm³ |',
);
console.log('|---|---|---|---|---|---|---|---|---|');
for (const { name, model, triangles, pattern, volumeMm3, ours } of cases) {
  const { preserved, resampled } = ours;
  const theirs = subtract(name);
  const cells = [
    basename(model),
    triangles,
    pattern,
    `${preserved.ms.toFixed(0)} (${resampled.ms.toFixed(0)})`,
    `${theirs.ms.toFixed(0)} (${theirs.takeMs.toFixed(0)})`,
    (preserved.ms / theirs.ms).toFixed(2),
    `${preserved.triangles} (${resampled.triangles})`,
    theirs.triangles,
    `${(volumeMm3 - preserved.volumeMm3).toFixed(2)}, ${(volumeMm3 - theirs.volume).toFixed(2)}`,
  ];
  console.log(`| ${cells.join(' | ')} |`);
}
