// SPDX-License-Identifier: GPL-3.0-or-later
// Measures a row of a batch on the built page, in Chromium: wall-clock and processor seconds, and memory after the
// fifth row and near the last.
//
//     script/bench page-batch [SAMPLE|MODEL] [ROWS] [PRINT_EVERY]
//
// Memory: WebAssembly heaps of the page's own engine and of the rows' engines, in use and allocated, and the
// proportional set size of all browser processes. The browser keeps its files in a new folder below build/bench, like
// a window that is not private.
import { chromium } from '@playwright/test';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { basename } from 'node:path';
import { preview } from 'vite';

const [model = 'bunny', rowsGiven = '200', printEvery = '1000000'] = process.argv.slice(2);
const rows = Number(rowsGiven);
const kEarly = 5; // rows before the first look at memory
const kLooks = 12,
  kBetweenLooksMs = 400; // an engine rests only between rows: its least use counts

const server = await preview({ preview: { host: '127.0.0.1', port: 0 } });
mkdirSync('build/bench', { recursive: true });
const folder = mkdtempSync('build/bench/chromium-');
const context = await chromium.launchPersistentContext(folder, {
  executablePath: process.env.QRELIEF_CHROMIUM ?? '/usr/bin/chromium',
  viewport: { width: 1280, height: 800 },
  serviceWorkers: 'block',
  args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox'],
});
const page = context.pages()[0] ?? (await context.newPage());

/** Asks the workers of all engines on the page. */
await page.addInitScript(() => {
  const Original = globalThis.Worker;
  const engines = new Set();
  globalThis.Worker = class extends Original {
    constructor(url, options) {
      super(url, options);
      if (options?.name === 'qrelief') engines.add(this);
    }
    terminate() {
      engines.delete(this);
      super.terminate();
    }
  };
  globalThis.engineMemory = () =>
    Promise.all(
      [...engines].map(
        (worker) =>
          new Promise((resolve) => {
            const id = `bench ${Math.random()}`;
            const listen = ({ data }) => {
              if (data.id !== id) return;
              worker.removeEventListener('message', listen);
              resolve(data.value);
            };
            worker.addEventListener('message', listen);
            worker.postMessage({ id, verb: 'memory', args: [] });
          }),
      ),
    );
});

const kTicksPerSecond = 100; // unit of processor time in /proc, on every Linux

/**
 * Sums memory in MB and processor time in s over the processes that name the folder on their command line, and their
 * children.
 */
function processes() {
  const pids = readdirSync('/proc').filter((name) => /^\d+$/.test(name));
  const read = (pid, file) => {
    try {
      return readFileSync(`/proc/${pid}/${file}`, 'utf8');
    } catch {
      return ''; // the process has ended
    }
  };
  const parents = new Map(pids.map((pid) => [pid, /^PPid:\s*(\d+)/m.exec(read(pid, 'status'))?.[1] ?? '0']));
  const isOurs = (pid) =>
    pid !== '0' && parents.has(pid) && (read(pid, 'cmdline').includes(basename(folder)) || isOurs(parents.get(pid)));
  const kinds = { renderer: 0, gpu: 0, other: 0 };
  let seconds = 0;
  for (const pid of pids.filter(isOurs)) {
    const kind = /--type=(renderer|gpu)/.exec(read(pid, 'cmdline'))?.[1] ?? 'other';
    kinds[kind] += Number(/^Pss:\s*(\d+)/m.exec(read(pid, 'smaps_rollup'))?.[1] ?? 0) / 1024;
    const [user = 0, system = 0] = read(pid, 'stat')
      .replace(/^.*\) /s, '')
      .split(' ')
      .slice(11, 13)
      .map(Number);
    seconds += (user + system) / kTicksPerSecond;
  }
  return { ...kinds, seconds };
}

async function memory() {
  let engines = await page.evaluate(() => globalThis.engineMemory());
  for (let looks = 1; looks < kLooks; looks += 1) {
    await page.waitForTimeout(kBetweenLooksMs);
    const now = await page.evaluate(() => globalThis.engineMemory());
    if (now.length !== engines.length) break;
    engines = engines.map(({ usedBytes }, i) => ({ ...now[i], usedBytes: Math.min(usedBytes, now[i].usedBytes) }));
  }
  const mb = (key) => engines.map((one) => (one[key] / 1e6).toFixed(1)).join(' + ');
  const { renderer, gpu, other, seconds } = processes();
  return {
    seconds,
    words:
      `engines use ${mb('usedBytes')} MB of heaps of ${mb('heapBytes')} MB; processes ${(renderer + gpu + other).toFixed(0)} MB ` +
      `(renderer ${renderer.toFixed(0)}, GPU ${gpu.toFixed(0)})`,
    used: engines.reduce((sum, { usedBytes }) => sum + usedBytes, 0),
    heap: engines.reduce((sum, { heapBytes }) => sum + heapBytes, 0),
    processes: renderer + gpu + other,
  };
}

/** @param {number} least  rows */
async function untilFinished(least) {
  for (;;) {
    const count = await page.locator('#parts-progress').evaluate((bar) => (bar.hidden ? Infinity : bar.value));
    if (count >= least) return;
    if (await page.locator('#alert').isVisible()) throw new Error(await page.locator('#alert').innerText());
    await page.waitForTimeout(100);
  }
}

try {
  const isFile = /\.\w+$/.test(model);
  await page.goto(`${server.resolvedUrls.local[0]}${isFile ? '' : `?sample=${model}`}`);
  await page.getByRole('status').getByText('Ready.').waitFor({ timeout: 300_000 });
  if (isFile) {
    await page.getByLabel('Model file').setInputFiles(model);
    await page.locator('#model-state').getByText(basename(model)).waitFor({ timeout: 300_000 });
  }
  await page.getByRole('radio', { name: 'A code for every part' }).check();
  await page.locator('#batch-from').selectOption('count');
  await page.getByLabel('Number of parts').fill(String(rows));
  await page.getByText(`${rows} parts,`).waitFor();
  await page.getByRole('status').getByText('Ready.').waitFor({ timeout: 300_000 });
  await page.getByRole('button', { name: 'Engrave the first part' }).click();
  await page
    .getByRole('status')
    .getByText(/^Engraved/)
    .waitFor({ timeout: 600_000 });
  console.log(
    `${await page.locator('#model-state').innerText()}; ${await page.locator('#placement-facts').innerText()}; first part ${await page.locator('#numbers dd').nth(2).innerText()}`,
  );
  await page.getByText(/^Simulating the print/).waitFor({ state: 'detached', timeout: 600_000 });
  await page.locator('#print-every').fill(printEvery);
  const begun = Date.now();
  await page.locator('#carve-all').click();
  await untilFinished(1);
  const first = Date.now();
  await untilFinished(kEarly);
  const early = await memory();
  console.log(`first row after ${((first - begun) / 1000).toFixed(1)} s; after row ${kEarly}: ${early.words}`);
  const from = Date.now(),
    before = kEarly;
  let late = early;
  for (let row = 25; row < rows; row += 25) {
    await untilFinished(row);
    late = await memory();
    console.log(`row ${row}: ${((Date.now() - from) / 1000 / (row - before)).toFixed(2)} s a row; ${late.words}`);
  }
  await untilFinished(rows - 6); // both engines are still at work
  late = await memory();
  const cpu = (late.seconds - early.seconds) / (rows - 6 - before);
  const grown = (key) => `${(100 * (late[key] / early[key] - 1)).toFixed(1)} %`;
  console.log(`at the end: ${late.words}`);
  await untilFinished(rows);
  console.log(
    `${((Date.now() - from) / 1000 / (rows - before)).toFixed(2)} s a row over ${rows - before} rows, ${cpu.toFixed(2)} s of the processor; ${await page.locator('#parts-state').innerText()}`,
  );
  console.log(
    `memory since row ${kEarly}: in use ${grown('used')}, heaps ${grown('heap')}, processes ${grown('processes')}`,
  );
} finally {
  await context.close();
  rmSync(folder, { recursive: true, force: true });
  server.httpServer.close();
}
