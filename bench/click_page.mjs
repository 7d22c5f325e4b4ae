// SPDX-License-Identifier: GPL-3.0-or-later
// Times the built page in Chromium with SwiftShader, on every sample with all defaults: a frame while a lamp is dragged and
// while the pointer moves over the model, seconds from the pointer's rest until the code under it is shown as it will be
// carved (after the first pass of the search / at its end), and seconds from a click on Engrave until the page allows the download and until it shows the print's verdict.
// Prints the three verdicts.
//
//     script/bench click [FOLDER] [SAMPLE]...      FOLDER: a built page (dist by default)
import { chromium } from '@playwright/test';
import { mkdirSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';

import { preview } from 'vite';

import { dragLamp, hover } from './page_frames.mjs';

const [folder = 'dist', ...wanted] = process.argv.slice(2);
const kText = 'https://example.org/p/0123456789';
const kLamp = '120,40,2'; // azimuth, elevation, strength
const kWait = { timeout: 120_000 };

/** In the page: notes when the file and the print are ready after a click. @param {Element} button */
function watch(button) {
  const { document, performance, MutationObserver } = /** @type {any} */ (globalThis);
  /** @type {{ file?: number, print?: number }} */ const seconds = /** @type {any} */ (globalThis.seconds = {});
  button.addEventListener(
    'click',
    () => {
      const start = performance.now();
      new MutationObserver(() => {
        const since = (performance.now() - start) / 1000;
        const download = document.getElementById('download'),
          lines = document.querySelectorAll('#verdict > li');
        if (download.offsetParent && !download.disabled) seconds.file ??= since;
        if (seconds.file !== undefined && lines.length > 0 && !document.querySelector('#verdict > .under-way'))
          seconds.print ??= since;
      }).observe(document.body, { attributes: true, childList: true, subtree: true });
    },
    { capture: true, once: true },
  );
}

/** @param {string} query */
async function open(query) {
  await page.goto(`${address}${query}`);
  await page.getByRole('status').filter({ hasText: 'Ready.' }).waitFor(kWait);
  await page.locator('#placement-facts').filter({ hasText: 'mm wide' }).waitFor(kWait);
  await page.waitForTimeout(1500); // work that is prepared while the user looks
}

const server = await preview({ preview: { host: '127.0.0.1', port: 0 }, build: { outDir: resolve(folder) } });
const address = server.resolvedUrls?.local[0];
const browser = await chromium.launch({
  executablePath: process.env.QRELIEF_CHROMIUM ?? '/usr/bin/chromium',
  args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox'],
});
const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, serviceWorkers: 'block' });
await page.goto(`${address}`);
const chooser = page.getByRole('combobox', { name: 'Sample model' });
await page.getByRole('status').filter({ hasText: 'Ready.' }).waitFor(kWait);
const samples =
  wanted.length > 0
    ? wanted
    : await chooser
        .locator('option[value]:not([value=""])')
        .evaluateAll((options) => options.map((option) => option.value));
mkdirSync('build/bench', { recursive: true });
console.log(
  '| sample | mm wide | a frame, lamp dragged, ms | pointer moves, ms | rest to carved preview, s | click to file, s | click to the print’s verdict, s | reads | prints | solid |\n|---|---:|---:|---:|---:|---:|---:|---|---|---|',
);
/** @type {string[]} */ const stages = [];
for (const sample of samples) {
  const query = `?sample=${sample}&text=${encodeURIComponent(kText)}`;
  await open(`${query}&light=${kLamp}`);
  const lampMs = await dragLamp(page);
  await open(query);
  const hovered = await hover(page);
  await open(query); // the pointer has disturbed what was prepared
  const width = /([\d.]+)\smm wide/.exec(await page.locator('#placement-facts').innerText())?.[1];
  const button = page.getByRole('button', { name: 'Engrave', exact: true });
  await button.evaluate(watch);
  await button.click();
  const lines = page
    .getByRole('region', { name: 'Result' })
    .getByRole('list', { name: 'Verdict' })
    .getByRole('listitem');
  await page.waitForFunction(() => /** @type {any} */ (globalThis).seconds?.print !== undefined, undefined, kWait);
  const { file, print } = await page.evaluate(() => /** @type {any} */ (globalThis).seconds);
  const levels = await lines.evaluateAll((items) => items.map((item) => item.textContent?.trim().slice(0, 60)));
  await page.screenshot({ path: `build/bench/click-${sample}.png` });
  const [saved] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save report' }).click(),
  ]);
  const { timingsMs } = JSON.parse(readFileSync(await saved.path(), 'utf8'));
  stages.push(
    `${sample}: ${Object.entries(timingsMs)
      .map(([stage, ms]) => `${stage} ${Math.round(Number(ms))}`)
      .join(', ')} ms`,
  );
  const secondsOr = (/** @type {number} */ ms) => (Number.isNaN(ms) ? 'over 5' : (ms / 1000).toFixed(2));
  const moved = hovered?.frameMs.toFixed(0) ?? 'no room';
  const shown = hovered ? `${secondsOr(hovered.previewMs)} / ${secondsOr(hovered.exactMs)}` : 'no room';
  const cells = [sample, width, lampMs.toFixed(0), moved, shown, file.toFixed(2), print.toFixed(2)];
  console.log(`| ${[...cells, ...levels].join(' | ')} |`);
}
console.log(`\nStages:\n\n${stages.join('\n')}`);
await browser.close();
await server.close();
