// SPDX-License-Identifier: GPL-3.0-or-later
// Compares our loading of a model with assimp and the loaders of three.js, in one run:
//
//     script/bench load MODEL [SCALE] [RUNS]
//
// Ours ends with a mesh that is welded, repaired, checked for crossing triangles and has its adjacency and normals. The
// others end with triangles that share equal corners; three.js for STL needs mergeVertices (its PLY loader keeps the
// file's vertices). script/bench installs three into build/bench; only this bench needs it.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const [bench, folder, model, scale = '1', runs = '5'] = process.argv.slice(2);
const require = createRequire(`${folder}/package.json`);
const load = (/** @type {string} */ path) => import(pathToFileURL(require.resolve(path)).href);

const rows = execFileSync(bench, [model, scale, runs], { encoding: 'utf8' })
  .trim()
  .split('\n')
  .map((line) => line.split(' '))
  .map(([name, ms, triangles]) => ({ name, ms: Number(ms), triangles: Number(triangles) }));

const extension = model.toLowerCase().split('.').pop();
const loaders = { stl: 'STLLoader', ply: 'PLYLoader', obj: 'OBJLoader' };
if (extension in loaders) {
  const loaderName = loaders[extension];
  const { [loaderName]: Loader } = await load(`three/examples/jsm/loaders/${loaderName}.js`);
  const { mergeVertices } = await load('three/examples/jsm/utils/BufferGeometryUtils.js');
  const file = readFileSync(model);
  const times = [];
  let triangles = 0;
  for (let run = 0; run < Number(runs); ++run) {
    const data =
      extension === 'obj' ? file.toString() : file.buffer.slice(file.byteOffset, file.byteOffset + file.length);
    const start = performance.now();
    const parsed = new Loader().parse(data);
    let geometry = extension === 'obj' ? parsed.children[0].geometry : parsed;
    if (!geometry.index) {
      geometry.deleteAttribute('normal');
      geometry = mergeVertices(geometry);
    }
    times.push(performance.now() - start);
    triangles = geometry.index.count / 3;
  }
  times.sort((a, b) => a - b);
  rows.push({ name: `three.js ${loaderName}`, ms: times[Math.floor(times.length / 2)], triangles });
}

const ours = rows.find((row) => row.name === 'qrelief').ms;
console.log(`${model}: median of ${runs} runs`);
for (const { name, ms, triangles } of rows)
  console.log(
    `${name.padEnd(20)} ${ms.toFixed(1).padStart(9)} ms  ${(ms / ours).toFixed(2).padStart(6)} of ours  ${triangles} triangles`,
  );
