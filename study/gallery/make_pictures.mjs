// SPDX-License-Identifier: GPL-3.0-or-later
// Renders and compresses the gallery's pictures, or checks the numbers under them: `script/gallery`.
/* global document, Image -- in the browser that compresses the pictures */
import { execFile } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { promisify } from 'node:util';
import { chromium } from '@playwright/test';
import { kPatterned, kPicturesFolder, kSamples, readGallery } from './exhibits.js';

/** @typedef {import('./exhibits.js').Exhibit} Exhibit */

const kProgram = 'build/release/bin/qrelief_gallery';
const kQuality = 0.92; // of WebP, 0 to 1; modules and layers stay clear
const kAlike = 0.1; // numbers may differ by this part: processors and GPUs do not round alike

const isCheck = process.argv[2] === '--check';
const names = process.argv.slice(isCheck ? 3 : 2);
for (const name of names.filter((name) => !kSamples.includes(name))) {
  console.error(`gallery: ${name} is not a sample; the samples are ${kSamples.join(', ')}`);
  process.exit(2);
}
const samples = names.length > 0 ? names : kSamples;

/** Engraves a sample's codes. @param {string} sample @param {string} folder @param {string[]} flags @returns {Promise<Exhibit[]>} */
async function exhibitsOf(sample, folder, flags) {
  await promisify(execFile)(kProgram, ['--samples', 'public/samples', '--out', folder, sample, ...flags]);
  return JSON.parse(readFileSync(`${folder}/${sample}.json`, 'utf8')).exhibits;
}

/** Runs a task for every sample, one on each processor at a time. @param {(sample: string) => Promise<void>} task */
async function forEachSample(task) {
  const left = [...samples];
  const work = async () => {
    for (let sample = left.shift(); sample; sample = left.shift()) await task(sample);
  };
  await Promise.all(Array.from({ length: availableParallelism() }, work));
}

/** @param {string} folder  for the program's files */
async function check(folder) {
  /** @type {string[]} */ const off = [];
  await forEachSample(async (sample) => {
    const kept = readGallery().find((room) => room.sample === sample)?.exhibits ?? [];
    const now = await exhibitsOf(sample, folder, []);
    now.forEach((exhibit, at) => {
      for (const key of /** @type {const} */ (['depthMm', 'moduleMm', 'reads', 'printedReads'])) {
        const [was, is] = [kept[at]?.[key] ?? NaN, exhibit[key]];
        const range = key === 'reads' || key === 'printedReads' ? exhibit.tries : is;
        if (!(Math.abs(was - is) <= kAlike * range))
          off.push(`${sample}, ${exhibit.kind}: ${key} was ${was}, is ${is}`);
      }
    });
  });
  for (const line of off) console.error(`gallery: ${line}; script/gallery makes the pictures again`);
  process.exitCode = off.length > 0 ? 1 : 0;
}

/** Returns the pictures as WebP. @param {import('@playwright/test').Page} page @param {string} file  PNG */
async function compressed(page, file) {
  const webp = await page.evaluate(
    async ([png, quality]) => {
      const image = new Image();
      image.src = `data:image/png;base64,${png}`;
      await image.decode();
      const canvas = document.createElement('canvas');
      Object.assign(canvas, { width: image.naturalWidth, height: image.naturalHeight });
      canvas.getContext('2d')?.drawImage(image, 0, 0);
      return canvas.toDataURL('image/webp', quality).split(',')[1];
    },
    /** @type {const} */ ([readFileSync(file, 'base64'), kQuality]),
  );
  return Buffer.from(webp, 'base64');
}

/** @param {string} folder  for the program's files */
async function make(folder) {
  mkdirSync(kPicturesFolder, { recursive: true });
  const browser = await chromium.launch({
    executablePath: process.env.QRELIEF_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox'],
  });
  await forEachSample(async (sample) => {
    const exhibits = await exhibitsOf(sample, folder, kPatterned.includes(sample) ? ['--patterns'] : []);
    const page = await browser.newPage();
    for (const file of readdirSync(kPicturesFolder).filter(
      (name) => /^(.*?)(-\d+-\w+\.webp|\.json)$/.exec(name)?.[1] === sample,
    ))
      rmSync(`${kPicturesFolder}/${file}`);
    for (const exhibit of exhibits) {
      for (const which of /** @type {const} */ (['designed', 'printed'])) {
        const file = exhibit[which].replace(/\.png$/, '.webp');
        writeFileSync(`${kPicturesFolder}/${file}`, await compressed(page, `${folder}/${exhibit[which]}`));
        exhibit[which] = file;
      }
    }
    writeFileSync(`${kPicturesFolder}/${sample}.json`, `${JSON.stringify({ sample, exhibits }, null, 1)}\n`);
    await page.close();
    console.log(`${sample}: ${exhibits.length} codes`);
  });
  await browser.close();
}

const folder = mkdtempSync(`${tmpdir()}/qrelief-gallery-`);
try {
  await (isCheck ? check : make)(folder);
} finally {
  rmSync(folder, { recursive: true });
}
