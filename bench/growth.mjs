// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how `engrave` takes longer with more triangles, modules or layers, and `batch` with more rows. Prints a table
// for each: seconds, the longest stage, and the exponent of each stage (time ~ size^exponent, fitted by least squares on
// logarithms to the larger half of the sizes). Draws all totals as FIGURE.svg.
//
//     script/bench growth FIGURE.svg [RUNS]
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const [, , figure, runs = '2'] = process.argv;
if (!figure) {
  console.error('usage: growth.mjs FIGURE.svg [RUNS]');
  process.exit(2);
}
const kCommand = 'build/release/bin/qrelief';
const kText = 'HTTPS://EXAMPLE.ORG/P/01'; // fits in version 2
const kRadiusMm = 60;
const kLeastMs = 5; // shorter stages have no meaningful exponent
const folder = mkdtempSync(join(tmpdir(), 'qrelief-growth-'));

/** Writes a sphere with low bumps as STL.
 * @param {number} triangles  about as many @param {number} radiusMm
 * @returns {string} its path */
function bumpySphere(triangles, radiusMm) {
  const rows = Math.max(4, Math.round(Math.sqrt(triangles / 4)));
  const columns = 2 * rows;
  const count = 2 * columns * (rows - 1);
  const bytes = Buffer.alloc(84 + 50 * count);
  bytes.writeUInt32LE(count, 80);
  const corner = (/** @type {number} */ row, /** @type {number} */ column) => {
    const down = (Math.PI * row) / rows;
    const round = (2 * Math.PI * (column % columns)) / columns;
    const along = row === 0 || row === rows ? 0 : Math.sin(down); // the poles are one point each
    const radius = radiusMm * (1 + 0.01 * along * Math.sin(5 * round) * Math.sin(4 * down));
    return [radius * along * Math.cos(round), radius * along * Math.sin(round), radius * Math.cos(down)];
  };
  let at = 84;
  const add = (/** @type {number[][]} */ ...corners) => {
    corners.flat().forEach((value, k) => bytes.writeFloatLE(value, at + 12 + 4 * k));
    at += 50;
  };
  for (let row = 0; row < rows; ++row)
    for (let column = 0; column < columns; ++column) {
      const [a, b] = [corner(row, column), corner(row, column + 1)];
      const [c, d] = [corner(row + 1, column), corner(row + 1, column + 1)];
      if (row > 0) add(a, c, b);
      if (row + 1 < rows) add(b, c, d);
    }
  const path = join(folder, `${triangles}-${radiusMm}.stl`);
  writeFileSync(path, bytes);
  return path;
}

/** Runs the command and returns its seconds.
 * @param {string[]} args */
function secondsOf(args) {
  const start = process.hrtime.bigint();
  const done = spawnSync(kCommand, args, { encoding: 'utf8', env: { ...process.env, QRELIEF_GL: 'software' } });
  if (done.status !== 0 && done.status !== 1) throw new Error(done.stderr);
  return Number(process.hrtime.bigint() - start) / 1e9;
}

/** Engraves, and returns the seconds of each stage and in total, the best of all runs.
 * @param {string} model @param {string[]} args @returns {Record<string, number>} */
function engrave(model, args) {
  const report = join(folder, 'r.json');
  /** @type {Record<string, number>} */ let best = { total: Infinity };
  for (let k = 0; k < Number(runs); ++k) {
    secondsOf(['engrave', model, '--text', kText, '-o', join(folder, 'c.stl'), '--report', report, ...args]);
    const { timingsMs } = JSON.parse(readFileSync(report, 'utf8'));
    if (timingsMs.total / 1000 < best.total)
      best = Object.fromEntries(Object.entries(timingsMs).map(([stage, ms]) => [stage, ms / 1000]));
  }
  return best;
}

/** Makes a batch, and returns its seconds, the best of all runs.
 * @param {string} model @param {number} rows @returns {Record<string, number>} */
function batch(model, rows) {
  let best = Infinity;
  for (let k = 0; k < Number(runs); ++k) {
    const out = mkdtempSync(join(folder, 'batch-'));
    const text = 'https://example.org/p/{n:05}';
    best = Math.min(best, secondsOf(['batch', model, '--count', `${rows}`, '--text', text, '--size', '30', '-o', out]));
    rmSync(out, { recursive: true });
  }
  return { total: best };
}

/** Returns the slope of log(seconds) over log(size) in the larger half of the sizes.
 * @param {number[]} sizes @param {number[]} seconds */
function exponentOf(sizes, seconds) {
  const first = Math.floor((sizes.length - 1) / 2);
  const points = sizes.slice(first).map((size, k) => [Math.log(size), Math.log(seconds[first + k])]);
  const mean = (/** @type {number} */ axis) => points.reduce((sum, p) => sum + p[axis], 0) / points.length;
  const [x, y] = [mean(0), mean(1)];
  const covariance = points.reduce((sum, p) => sum + (p[0] - x) * (p[1] - y), 0);
  return covariance / points.reduce((sum, p) => sum + (p[0] - x) ** 2, 0);
}

const fine = bumpySphere(1e5, kRadiusMm);
const wide = bumpySphere(1e5, 2 * kRadiusMm);
const kAtEquator = ['--at', `${kRadiusMm},0,0`];
/** @type {{name: string, sizes: number[], measure: (size: number) => Record<string, number>}[]} */
const kSweeps = [
  {
    name: 'triangles',
    sizes: [1e4, 3e4, 1e5, 3e5, 1e6, 2e6, 5e6],
    measure: (size) => engrave(bumpySphere(size, kRadiusMm), ['--size', '30']),
  },
  {
    name: 'modules along the edge',
    sizes: [25, 29, 33, 37, 41, 45, 49, 53, 57],
    measure: (size) =>
      engrave(wide, ['--at', `${2 * kRadiusMm},0,0`, '--version', `${(size - 17) / 4}`, '--size', `${1.2 * size}`]),
  },
  {
    name: 'layers a millimetre',
    sizes: [2.5, 5, 10, 20],
    measure: (size) => engrave(fine, [...kAtEquator, '--size', '30', '--nozzle', '0.4', '--layer', `${1 / size}`]),
  },
  { name: 'rows of a batch', sizes: [2, 4, 8, 16, 32], measure: (size) => batch(fine, size) },
];

/** Draws curves of seconds on logarithmic axes, each over its own range of sizes.
 * @param {{name: string, sizes: number[], seconds: number[]}[]} curves */
function svgOf(curves) {
  const [width, height, margin] = [640, 360, 48];
  const all = curves.flatMap(({ seconds }) => seconds);
  const low = Math.floor(Math.log10(Math.min(...all)));
  const high = Math.ceil(Math.log10(Math.max(...all)));
  const y = (/** @type {number} */ s) =>
    height - margin - ((Math.log10(s) - low) / (high - low)) * (height - 2 * margin);
  const colours = ['#0072b2', '#d55e00', '#009e73', '#cc79a7'];
  const parts = [];
  for (let decade = low; decade <= high; ++decade)
    parts.push(
      `<path d="M${margin} ${y(10 ** decade)}H${width - margin}" stroke="#ccc"/>`,
      `<text x="${margin - 6}" y="${y(10 ** decade) + 4}" text-anchor="end">${10 ** decade} s</text>`,
    );
  curves.forEach(({ name, sizes, seconds }, k) => {
    const [first, last] = [Math.log(sizes[0]), Math.log(sizes[sizes.length - 1])];
    const x = (/** @type {number} */ size) =>
      margin + ((Math.log(size) - first) / (last - first)) * (width - 2 * margin);
    const points = sizes.map((size, i) => `${x(size).toFixed(1)},${y(seconds[i]).toFixed(1)}`);
    parts.push(
      `<polyline points="${points.join(' ')}" fill="none" stroke="${colours[k]}" stroke-width="2"/>`,
      ...points.map((p) => `<circle cx="${p.split(',')[0]}" cy="${p.split(',')[1]}" r="3" fill="${colours[k]}"/>`),
      `<text x="${margin + 280 * (k % 2)}" y="${18 + 16 * Math.floor(k / 2)}" fill="${colours[k]}">${name}: ${sizes[0]} to ${sizes[sizes.length - 1]}</text>`,
    );
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" font-family="sans-serif" font-size="12">
<rect width="${width}" height="${height}" fill="#fff"/>
${parts.join('\n')}
</svg>
`;
}

const curves = [];
for (const { name, sizes, measure } of kSweeps) {
  const measured = sizes.map((size) => measure(size));
  console.log(`\n| ${name} | s | longest stage | s |\n|---:|---:|---|---:|`);
  measured.forEach((stages, k) => {
    const [longest, seconds] = Object.entries(stages)
      .filter(([stage]) => stage !== 'total')
      .reduce((a, b) => (b[1] > a[1] ? b : a), ['', 0]);
    console.log(
      `| ${sizes[k].toLocaleString('en')} | ${stages.total.toFixed(2)} | ${longest} | ${longest ? seconds.toFixed(2) : ''} |`,
    );
  });
  const exponents = Object.keys(measured[0])
    .filter((stage) => measured.every((stages) => 1000 * stages[stage] >= kLeastMs))
    .map(
      (stage) =>
        `${stage} ${exponentOf(
          sizes,
          measured.map((stages) => stages[stage]),
        ).toFixed(2)}`,
    );
  console.log(`\nExponents: ${exponents.join(', ')}`);
  curves.push({ name, sizes, seconds: measured.map((stages) => stages.total) });
}
writeFileSync(figure, svgOf(curves));
rmSync(folder, { recursive: true });
