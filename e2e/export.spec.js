// SPDX-License-Identifier: GPL-3.0-or-later
// The downloads next to the carved model, and loading saved settings.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test } from '@playwright/test';
import { decodePng } from './support/decode.js';
import { Engraver } from './support/engraver.js';
import { saddleFile } from './support/models.js';
import { poll } from './support/poll.js';
import { filesOf } from './support/three_mf.js';

/** @typedef {import('@playwright/test').Page} Page */

const kCommand = fileURLToPath(new URL('../build/release/bin/qrelief', import.meta.url));
const kText = 'https://example.org/Grüße?a=1&b=<2>';

/**
 * Drops a file onto the page like a user.
 * @param {Page} page
 * @param {{ name: string, bytes: Uint8Array | string }} file
 */
async function drop(page, { name, bytes }) {
  const transfer = await page.evaluateHandle(
    ([fileName, content]) => {
      const data = new DataTransfer();
      data.items.add(new File([content], fileName, { type: 'application/json' }));
      return data;
    },
    [name, typeof bytes === 'string' ? bytes : new TextDecoder().decode(bytes)],
  );
  for (const type of ['dragenter', 'dragover', 'drop'])
    await page.dispatchEvent('#view', type, { dataTransfer: transfer });
}

/**
 * Shows a picture file in a page of its own and takes a screenshot.
 * @param {Page} page
 * @param {Uint8Array} bytes
 * @param {string} type
 */
async function screenshotOf(page, bytes, type) {
  const other = await page.context().newPage();
  await other.setContent(
    `<body style="margin:0"><img style="width:400px" src="data:${type};base64,${Buffer.from(bytes).toString('base64')}">`,
  );
  await poll(() =>
    other.locator('img').evaluate((img) => /** @type {HTMLImageElement} */ (img).naturalWidth),
  ).toBeGreaterThan(0);
  const png = await other.locator('img').screenshot();
  await other.close();
  return png;
}

/**
 * Returns the arrays of 32-bit floats in an NPZ file, by the names of their files.
 * @param {Uint8Array} npz
 * @returns {Map<string, { shape: string, values: Float32Array }>}
 */
function numpyArrays(npz) {
  const arrays = [...filesOf(npz)].map(([file, npy]) => {
    const begin = 10 + npy.readUInt16LE(8);
    const [, shape] =
      /'descr': '<f4', 'fortran_order': False, 'shape': \((.*)\)/.exec(npy.toString('latin1', 10, begin)) ?? [];
    const values = new Float32Array(new Uint8Array(npy.subarray(begin)).buffer);
    return /** @type {const} */ ([file, { shape, values }]);
  });
  return new Map(arrays);
}

test('The symbol as SVG and PNG decodes, and its file names the content', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  await app.text.fill(kText);
  await app.expectReady();
  const svg = await app.download('Code as SVG');
  expect(svg.name).toBe('qr-example.org.svg');
  expect(await decodePng(await screenshotOf(page, svg.bytes, 'image/svg+xml'))).toBe(kText);
  const [, width] = /width="([\d.]+)mm"/.exec(new TextDecoder().decode(svg.bytes)) ?? [];
  const [, modules] = /(\d+) × \d+ modules/.exec(await page.locator('#symbol-facts').innerText()) ?? [];
  const symbolMm = Number(/^([\d.]+)\smm wide/.exec(await app.placement.innerText())?.[1]);
  expect(Math.abs(Number(width) - (symbolMm * (Number(modules) + 8)) / Number(modules))).toBeLessThan(0.1);

  const png = await app.download('Code as PNG');
  expect(png.name).toBe('qr-example.org.png');
  expect(await decodePng(png.bytes)).toBe(kText);

  await test.step('A saved picture equals the view', async () => {
    await app.text.fill('PICTURE 1');
    await app.openSettings();
    await app.setting('Modules').selectOption('Full');
    await app.setting('Finder patterns').selectOption('Full');
    await app.expectReady();
    await page.getByRole('button', { name: 'Phone view' }).click();
    await poll(async () => decodePng(await app.canvas.screenshot()), { timeout: 60_000 }).toBe('PICTURE 1');
    const picture = await app.download('Save picture');
    expect(picture.name).toMatch(/^saddle-qr-PICTURE-1-\d+mm-view\.png$/);
    expect(await decodePng(picture.bytes)).toBe('PICTURE 1');
  });
});

test('A dropped settings file and a shared link restore the settings', async ({ page, context }) => {
  const app = new Engraver(page);
  await app.open('?sample=bumpy-sphere');
  await app.expectReady();
  await app.text.fill(kText);
  await app.openSettings();
  await app.setting('Size of the code').selectOption('Exactly');
  await app.setting('Width (mm)').fill('21.5');
  await app.setting('Modules').selectOption('Diamond');
  await app.setting('Minimum wall (mm)').fill('1.25');
  await app.setting('Minimum wall (mm)').blur();
  await expect(app.placement).toContainText('21.5 mm wide');
  await app.expectReady();
  const centre = await app.centre();
  const file = await app.download('Save settings');
  expect(file.name).toBe('bumpy-sphere-qr-example.org-22mm-settings.json');
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.getByRole('button', { name: 'Share link' }).click();
  await expect(app.status).toHaveText('Link copied.');
  const link = await page.evaluate(() => navigator.clipboard.readText());

  await app.open('?sample=saddle');
  await app.expectReady();
  await drop(page, file);
  await expect(app.status).toHaveText(`Using the settings from ${file.name}.`);
  await expect(app.text).toHaveValue(kText);
  await expect(app.sample).toHaveValue('bumpy-sphere');
  await expect(app.placement).toContainText('21.5 mm wide');
  expect(await app.centre()).toEqual(centre);
  await app.openSettings();
  await expect(app.setting('Size of the code')).toHaveValue('fixed');
  await expect(app.setting('Modules')).toHaveValue('diamond');
  await expect(app.setting('Minimum wall (mm)')).toHaveValue('1.25');
  expect((await app.download('Save settings')).bytes).toEqual(file.bytes);

  await test.step('A shared link opens the page with the same sample, spot, text and settings', async () => {
    await page.goto(link);
    await app.expectReady();
    await expect(app.text).toHaveValue(kText);
    await expect(app.sample).toHaveValue('bumpy-sphere');
    await expect(app.placement).toContainText('21.5 mm wide');
    (await app.centre()).forEach((mm, axis) => expect(mm).toBeCloseTo(centre[axis], 1));
    await app.openSettings();
    await expect(app.setting('Modules')).toHaveValue('diamond');
    await expect(app.setting('Minimum wall (mm)')).toHaveValue('1.25');
  });

  await test.step('The file field accepts settings too and keeps the user’s model', async () => {
    await app.file.setInputFiles(saddleFile);
    await expect(app.facts).toContainText('my saddle.stl');
    await expect(app.status).toHaveText('Ready.');
    await app.file.setInputFiles({ name: 'again.json', mimeType: 'application/json', buffer: Buffer.from(file.bytes) });
    await expect(app.status).toHaveText('Using the settings from again.json.');
    await expect(app.sample).toHaveValue('bumpy-sphere');

    await app.file.setInputFiles(saddleFile);
    await expect(app.facts).toContainText('my saddle.stl');
    await expect(app.status).toHaveText('Ready.');
    const proposed = await app.centre();
    const foreign = JSON.parse(new TextDecoder().decode(file.bytes));
    foreign.model = { file: 'vessel.stl', scaleToMm: 1, upAxis: 'z', centreMm: [1, 2, 3] };
    foreign.settings.text = 'for another';
    await drop(page, { name: 'vessel.json', bytes: JSON.stringify(foreign) });
    await expect(app.status).toHaveText(
      'Using the settings from vessel.json, made for vessel.stl: choose the spot on this model.',
    );
    await expect(app.text).toHaveValue('for another');
    expect(await app.centre()).toEqual(proposed);
  });

  await test.step('Invalid settings change nothing and are reported', async () => {
    const good = JSON.parse(new TextDecoder().decode((await app.download('Save settings')).bytes));
    const text = await app.text.inputValue();
    const wrong = [
      ['not json', '“x.json” is not a JSON file.'],
      [JSON.stringify({ qrelief: '0.1.0' }), '“x.json” is a report, not settings.'],
      [JSON.stringify({ ...good, version: 9 }), '“x.json” has settings of version 9'],
      [
        JSON.stringify({ ...good, settings: { ...good.settings, text: 'other', nozzleMm: -1 } }),
        '“Nozzle” is -1 mm. Choose from 0.01 mm to 10 mm.',
      ],
    ];
    for (const [bytes, message] of wrong) {
      await drop(page, { name: 'x.json', bytes });
      await expect(app.alert).toContainText(message);
      await expect(app.text).toHaveValue(text);
      await page.getByRole('button', { name: 'Dismiss' }).click();
    }
    await expect(app.engraveButton).toBeEnabled();
  });
});

test('The maps are the arrays that the command writes', async ({ page }, testInfo) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  await app.engrave();
  const { name, bytes } = await app.download('Save maps (.npz)');
  expect(name).toMatch(/^saddle-qr-.*-maps\.npz$/);
  const report = await app.report();

  const [model, maps] = [testInfo.outputPath('saddle.stl'), testInfo.outputPath('maps.npz')];
  writeFileSync(model, await (await page.request.get('samples/saddle.stl')).body());
  const at = `--at=${report.projection.centre.join(',')}`;
  const out = testInfo.outputPath('carved.stl');
  execFileSync(kCommand, ['engrave', model, '--text', report.text, at, '-o', out, '--maps', maps, '--quiet']);
  const [ours, commands] = [numpyArrays(bytes), numpyArrays(readFileSync(maps))];
  const shapes = (/** @type {typeof ours} */ arrays) => [...arrays].map(([file, { shape }]) => [file, shape]);
  expect(shapes(ours)).toEqual(shapes(commands));
  expect(ours.size).toBe(6);
  const deepestMm = (/** @type {typeof ours} */ arrays) => Math.max(...(arrays.get('depth.npy')?.values ?? []));
  expect(deepestMm(ours)).toBeCloseTo(report.depth.maxMm, 4);
  expect(Math.abs(deepestMm(ours) - deepestMm(commands))).toBeLessThan(0.05);
});
