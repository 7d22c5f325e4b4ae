// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the time of `engrave` in this build and in another one. Runs both in turn and keeps the best run of each.
// Prints wall time, processor time and their ratios (below 1: this build is faster).
//
//     script/bench proof OTHER/qrelief MODEL SCALE X,Y,Z [RUNS]
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const [, , other, model, scale, centre, runs = '5'] = process.argv;
if (!centre) {
  console.error('usage: whole_proof.mjs OTHER/qrelief MODEL SCALE X,Y,Z [RUNS]');
  process.exit(2);
}
const kOurs = 'build/release/bin/qrelief';
const kText = 'https://example.org/p/0123456789';
const folder = mkdtempSync(join(tmpdir(), 'qrelief-proof-'));

/** Runs a command: wall-clock and processor seconds, and the stages of its report.
 * @param {string} command @param {string[]} args */
function run(command, args) {
  const report = join(folder, 'r.json');
  const all = [
    'engrave',
    model,
    '--scale',
    scale,
    '--text',
    kText,
    '-o',
    join(folder, args.includes('paint') ? 'c.3mf' : 'c.stl'),
    '--report',
    report,
    '--quiet',
    ...args,
  ];
  const done = spawnSync(
    'bash',
    ['-c', 'TIMEFORMAT="%R %U %S"; time "$@" >/dev/null 2>/dev/null', 'run', command, ...all],
    { encoding: 'utf8', env: { ...process.env, QRELIEF_GL: 'software' } },
  );
  const [wall, user, system] = done.stderr.trim().split('\n').at(-1).split(' ').map(Number);
  return { wall, processor: user + system, stages: JSON.parse(readFileSync(report, 'utf8')).timingsMs };
}

const kCases = {
  'given spot, 25 mm': ['--size', '25', `--at=${centre}`],
  'given spot, 25 mm, `--process none`': ['--size', '25', '--process', 'none', `--at=${centre}`],
  'best spot, 36 mm': ['--size', '36'],
  'best spot, 36 mm, painted': ['--size', '36', '--mark', 'paint'],
};

console.log(
  '| | seconds, other | this | ratio | of the processor, other | this | ratio |\n|---|---:|---:|---:|---:|---:|---:|',
);
/** @type {string[]} */ const stages = [];
for (const [name, args] of Object.entries(kCases)) {
  const best = [other, kOurs].map(() => ({ wall: Infinity, processor: Infinity, stages: {} }));
  for (let k = 0; k < Number(runs); ++k)
    [other, kOurs].forEach((command, which) => {
      const { wall, processor, stages: taken } = run(command, args);
      if (wall < best[which].wall) Object.assign(best[which], { wall, stages: taken });
      best[which].processor = Math.min(best[which].processor, processor);
    });
  const [old, ours] = best;
  const columns = [
    old.wall,
    ours.wall,
    ours.wall / old.wall,
    old.processor,
    ours.processor,
    ours.processor / old.processor,
  ];
  console.log(`| ${name} | ${columns.map((value) => value.toFixed(2)).join(' | ')} |`);
  stages.push(
    `${name}: ${Object.entries(ours.stages)
      .map(([stage, ms]) => `${stage} ${Math.round(ms)}`)
      .join(', ')} ms`,
  );
}
console.log(`\nStages of this build:\n\n${stages.join('\n')}`);
rmSync(folder, { recursive: true });
