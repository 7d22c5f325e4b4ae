// SPDX-License-Identifier: GPL-3.0-or-later
// Engraves codes into generated files of several bodies, and checks that every body stays a body: closed and manifold,
// the other bodies bit for bit, names, extruders and paint kept. PrusaSlicer opens the files that it can open before and
// after.
//
//     node check.mjs QRELIEF FOLDER FIRST_SEED LAST_SEED
//
// A seed decides the scene and the manner of its file, and every mark is engraved into it.
import { execFile } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { promisify } from 'node:util';
import { firstDifference, INLAY, opened, splitShells } from './compare.mjs';
import { read3mf, readObj, readStl, worldCorners } from './readers.mjs';
import { oneOf, randomOf, sceneOf } from './scenes.mjs';
import { faultOf, volumeOf, welded } from './solidity.mjs';
import { manners } from './writers.mjs';

/** @typedef {import('./readers.mjs').FileBody} FileBody */
/** @typedef {{ seed: number, mark: string, outcome: 'engraved' | 'no place' | 'wrong', said: string }} Outcome */

const MARKS = ['shadow', 'inlay', 'paint'];
const VOLUME_ERROR = 1e-6; // of the body's volume: corners are rounded to 32-bit floats
const NO_PLACE = 4; // exit status of an engraving that finds no solution
// The smallest symbol, and no simulated print: only the mesh matters.
const CHEAP = ['--text', 'A', '--ecc', 'L', '--mask', '0', '--process', 'none', '--max-size', '16', '--quiet'];

const [command, folder, first, last] = process.argv.slice(2);
const run = promisify(execFile);

/** Runs a command. @param {string} program @param {string[]} options @returns {Promise<{ status: number, said: string }>} */
async function status(program, options) {
  try {
    const { stdout, stderr } = await run(program, options);
    return { status: 0, said: stdout + stderr };
  } catch (error) {
    const { code, stdout, stderr } = /** @type {any} */ (error);
    return { status: typeof code === 'number' ? code : 5, said: `${stdout}${stderr}` };
  }
}

/** Reads the bodies of a file; an STL has one. @param {string} file @returns {FileBody[]} */
function bodiesOf(file) {
  const bytes = readFileSync(file);
  if (file.endsWith('.3mf')) return read3mf(bytes);
  if (file.endsWith('.obj')) return readObj(bytes);
  return [{ name: '', object: '', extruder: '', isModel: true, mesh: readStl(bytes), transforms: '', paint: [] }];
}

/**
 * Returns what is wrong with an engraved file; empty if nothing is.
 * @param {FileBody[]} before
 * @param {FileBody[]} after  without the inlay
 * @param {FileBody | undefined} inlay
 * @param {string} mark
 * @param {any} report
 */
function faultsOf(before, after, inlay, mark, report) {
  const models = before.filter(({ isModel }) => isModel);
  if (report.mesh.bodies !== models.length)
    return [`the report counts ${report.mesh.bodies} bodies instead of ${models.length}`];
  const carved = before.indexOf(models[report.mesh.carvedBody - 1]);
  if (after.length !== before.length) return [`${after.length} bodies instead of ${before.length}`];
  const faults = before.flatMap((body, i) => {
    const difference = firstDifference(body, after[i], i === carved);
    return difference ? [`${body.name || `body ${i + 1}`}: ${difference}`] : [];
  });
  if (before[carved].name !== report.mesh.carvedBodyName && before[carved].name !== '')
    faults.push(`the report names "${report.mesh.carvedBodyName}" instead of "${before[carved].name}"`);
  for (const body of [...after.filter(({ isModel }) => isModel), ...(inlay ? [inlay] : [])]) {
    const fault = faultOf(body.mesh);
    if (fault) faults.push(`${body.name}: ${fault}`);
  }
  const [was, is] = [volumeOf(before[carved].mesh), volumeOf(after[carved].mesh) + (inlay ? volumeOf(inlay.mesh) : 0)];
  if (mark === 'shadow' ? is >= was : Math.abs(is - was) > VOLUME_ERROR * was)
    faults.push(`${mark}: a volume of ${is} mm³ was ${was} mm³`);
  return faults;
}

/** Returns what is wrong with a written file. @param {string} file @param {string} extension @param {string} mark @param {FileBody[]} before @param {any} report */
function checked(file, extension, mark, before, report) {
  let after = bodiesOf(file);
  /** @type {FileBody | undefined} */ let inlay;
  if (mark === 'inlay' && extension === 'stl') inlay = bodiesOf(file.replace('.stl', '-2.stl'))[0];
  else if (mark === 'inlay') inlay = after.find(({ name }) => name === INLAY);
  after = after.filter((body) => body !== inlay);
  if (mark === 'inlay' && !inlay) return ['there is no inlay'];
  if (inlay) inlay.mesh = welded(inlay.mesh);
  if (extension !== '3mf') {
    const carved = report.mesh.carvedBody - 1;
    const split = splitShells(before, after, carved);
    if (typeof split === 'string') return [split];
    after = split;
  }
  return faultsOf(before, after, inlay, mark, report);
}

/** Engraves one mark into a seed's file. @param {number} seed @param {string} mark @returns {Promise<Outcome>} */
async function engraved(seed, mark) {
  const manner = manners[seed % manners.length];
  const random = randomOf(seed + MARKS.indexOf(mark) / MARKS.length);
  const scene = sceneOf(seed);
  const input = `${folder}/${seed}-${mark}-in.${manner.extension}`;
  const extension = manner.extension === 'stl' && mark === 'paint' ? '3mf' : manner.extension; // STL has no paint
  const [output, reportFile] = [`${folder}/${seed}-${mark}.${extension}`, `${folder}/${seed}-${mark}.json`];
  writeFileSync(input, await manner.write(scene, randomOf(seed)));
  const before =
    manner.extension === 'stl'
      ? scene.map(
          (body) =>
            /** @type {FileBody} */ ({
              ...body,
              object: '',
              isModel: true,
              name: '',
              extruder: '',
              transforms: '',
              paint: [],
            }),
        )
      : bodiesOf(input);
  const options = ['engrave', input, '-o', output, '--report', reportFile, '--mark', mark, ...CHEAP];
  const top = topOf(
    oneOf(
      random,
      before.filter(({ isModel }) => isModel),
    ),
  );
  /** @type {(outcome: Outcome['outcome'], said: string) => Outcome} */
  const done = (outcome, said) => ({
    seed,
    mark,
    outcome,
    said: `${manner.name}: ${said}\n  ${command} ${options.join(' ')}`,
  });
  let result = await status(command, [...options, '--at', top.join(',')]);
  if (result.status === NO_PLACE) result = await status(command, options); // another body may be in the way
  if (result.status === NO_PLACE) return done('no place', result.said.trim());
  if (result.status > 1) return done('wrong', `exit status ${result.status}: ${result.said.trim()}`);
  const report = JSON.parse(readFileSync(reportFile, 'utf8'));
  const faults = checked(output, manner.extension, mark, before, report);
  if (manner.opensInPrusaSlicer) faults.push(...(await opened(input, output)));
  return faults.length > 0 ? done('wrong', faults.join('; ')) : done('engraved', result.said.trim());
}

/** Returns the middle of a body's top, in the file's frame. @param {FileBody} body */
function topOf(body) {
  const corners = worldCorners(body);
  const [low, high] = [Math.min, Math.max].map((of) =>
    [0, 1, 2].map((k) => corners.reduce((a, p) => of(a, p[k]), corners[0][k])),
  );
  return [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, high[2]];
}

const jobs = [];
for (let seed = Number(first); seed <= Number(last); seed += 1) for (const mark of MARKS) jobs.push({ seed, mark });
/** @type {Outcome[]} */ const outcomes = [];
await Promise.all(
  Array.from({ length: availableParallelism() }, async () => {
    for (let job = jobs.shift(); job; job = jobs.shift()) {
      const { seed, mark } = job;
      const outcome = await engraved(seed, mark).catch(
        (error) => /** @type {Outcome} */ ({ seed, mark, outcome: 'wrong', said: String(error.stack) }),
      );
      if (outcome.outcome !== 'engraved') console.log(`seed ${seed}, ${mark}: ${outcome.outcome}: ${outcome.said}`);
      outcomes.push(outcome);
    }
  }),
);
const count = (/** @type {Outcome['outcome']} */ kind) => outcomes.filter(({ outcome }) => outcome === kind).length;
console.log(
  `${outcomes.length} engravings: ${count('engraved')} with every body as it should be, ${count('no place')} without a place, ${count('wrong')} wrong`,
);
if (count('wrong') > 0) process.exitCode = 1;
