// SPDX-License-Identifier: GPL-3.0-or-later
// Codes in a second colour: chosen, shown, read and saved with both filaments.
import { expect, test } from '@playwright/test';
import { checkSolid, volume } from '../web/samples/solid.js';
import { readStl } from '../web/samples/stl.js';
import { decodePng } from './support/decode.js';
import { Engraver } from './support/engraver.js';
import { isDark, shareOf } from './support/pixels.js';
import { poll } from './support/poll.js';
import { bodiesOf, coloursOf, extrudersOf, filesOf, modelsOf, paintedIn, unzip } from './support/three_mf.js';

const kSolid = { openEdges: 0, nonManifoldEdges: 0, nonManifoldVertices: 0, degenerateTriangles: 0 };
const kCost =
  /Second colour\s*\d+ filament changes?, [\d.]+\sg and\s\d+\smin of waste; plus up to\s[\d.]+\sg for a wipe tower/;

/** Where the materials bleed into each other. @type {import('./support/pixels.js').Colour} */
const isBetween = (red) => red > 90 && red < 165;

/** Opens the plate with a short code. @param {import('@playwright/test').Page} page */
async function open(page) {
  const app = new Engraver(page);
  await app.open('?sample=plate&text=A');
  await app.expectReady();
  const plate = readStl(new Uint8Array(await (await page.request.get('samples/plate.stl')).body()));
  return { app, plate };
}

test('A painted code keeps the model’s shape and has the second filament', async ({ page }) => {
  const { app, plate } = await open(page);
  const choice = page.locator('#step-carve');
  await app.setting('Made by').selectOption('Second colour, painted');
  await app.engrave(); // at once: a choice made just before Engrave is engraved, too
  await expect(choice).toContainText('about one filament change per layer');
  await expect(app.setting('How deep')).toBeHidden();

  await test.step('The numbers say what the colour costs, and no depth', async () => {
    await expect(app.result).toContainText('Reads as A');
    await expect(app.result).toContainText(kCost);
    await expect(app.result.locator('dl')).not.toContainText('Depth');
    await expect(choice).toContainText(/This code: \d+ filament change/);
    await expect(page.getByRole('button', { name: 'Depths', exact: true })).toBeHidden();
  });

  await test.step('The view shows the code in its colours', async () => {
    await page.getByRole('button', { name: 'Phone view' }).click();
    await poll(async () => decodePng(await app.canvas.screenshot())).toBe('A');
  });

  await test.step('The print is shown beside the design, in both colours and with softer borders', async () => {
    const between = () => shareOf(app.canvas, isBetween);
    const designed = await between();
    await page.getByRole('button', { name: 'As printed' }).click();
    await expect(page.getByRole('group', { name: 'Phone view' })).toContainText('reads');
    await poll(between).not.toBe(designed);
    await poll(async () => decodePng(await app.canvas.screenshot())).toBe('A');
    expect(await shareOf(app.canvas, isDark)).toBeGreaterThan(0.02);
    await page.getByRole('button', { name: 'As designed' }).click();
  });

  await test.step('Only 3MF is offered, and its facets have two filaments', async () => {
    await expect(app.setting('Format').locator('option:not([disabled])')).toHaveText(['3MF, two colours']);
    await expect(app.result).toContainText('Only 3MF holds both colours in one file.');
    const { name, bytes } = await app.download();
    expect(name).toMatch(/^plate-qr-A-\d+mm-paint\.3mf$/);
    const files = unzip(bytes);
    const models = modelsOf(files);
    expect(coloursOf(models).size).toBe(2);
    const [body, ...others] = [...bodiesOf(models).values()];
    expect(others).toEqual([]);
    expect(checkSolid(body.mesh)).toMatchObject(kSolid);
    expect(volume(body.mesh) / volume(plate)).toBeCloseTo(1, 9);
    const { prusa, bambu } = paintedIn(models);
    expect(prusa).toBeGreaterThan(100);
    expect(bambu).toBe(prusa);
  });

  await test.step('For PrusaSlicer, the file has its attribute alone', async () => {
    await app.setting('For').selectOption('PrusaSlicer');
    const { prusa, bambu } = paintedIn(modelsOf(unzip((await app.download()).bytes)));
    expect(prusa).toBeGreaterThan(100);
    expect(bambu).toBe(0);
  });

  await test.step('A code of one colour has all formats again', async () => {
    await app.setting('Made by').selectOption('Shadow');
    await app.expectReady();
    await expect(app.setting('How deep')).toBeVisible();
    await app.engrave();
    await expect(app.setting('Format')).toHaveValue('stl');
    await expect(app.setting('For')).toBeHidden();
    await expect(app.setting('Format').locator('option:not([disabled])')).toHaveCount(5);
    await expect(app.result).toContainText(/Depth\s*[\d.]+\smm on average/);
  });
});

test('An inlaid code and its model are two solids that fill the model exactly', async ({ page }) => {
  const { app, plate } = await open(page);
  await app.setting('Made by').selectOption('Second colour, inlaid');
  await app.engrave(); // at once, as above
  await expect(app.result).toContainText('Reads as A');
  await expect(app.result).toContainText(/Depth\s*[\d.]+\smm/);
  await expect(app.result).toContainText(kCost);
  const { name, bytes } = await app.download();
  expect(name).toMatch(/^plate-qr-A-\d+mm-inlay\.3mf$/);
  const files = unzip(bytes);
  const bodies = bodiesOf(modelsOf(files));
  const [bodyId, inlayId] = [...bodies.keys()];
  expect(bodies.size).toBe(2);
  const [body, inlay] = [...bodies.values()];
  for (const { mesh } of [body, inlay]) expect(checkSolid(mesh)).toMatchObject(kSolid);
  expect((volume(body.mesh) + volume(inlay.mesh)) / volume(plate)).toBeCloseTo(1, 6);
  expect(inlay.colour).not.toBe(body.colour);
  const extruders = { [bodyId]: '1', [inlayId]: '2' };
  expect(extrudersOf(files)).toEqual({ bambu: extruders, prusa: extruders });

  await test.step('As STL, model and inlay are two files in a ZIP', async () => {
    await app.setting('Format').selectOption('STL');
    await expect(app.result).toContainText('A ZIP with two STL files');
    const zip = await app.download();
    expect(zip.name).toMatch(/^plate-qr-A-\d+mm-inlay\.zip$/);
    const stl = filesOf(zip.bytes);
    const stem = zip.name.replace('-inlay.zip', '');
    expect([...stl.keys()]).toEqual([`${stem}.stl`, `${stem}-2.stl`]);
    const solids = [...stl.values()].map((content) => readStl(new Uint8Array(content)));
    for (const mesh of solids) expect(checkSolid(mesh)).toMatchObject(kSolid);
    expect((volume(solids[0]) + volume(solids[1])) / volume(plate)).toBeCloseTo(1, 6);
  });

  await test.step('The view shows the inlay in its colour', async () => {
    await page.getByRole('button', { name: 'Phone view' }).click();
    await poll(async () => decodePng(await app.canvas.screenshot())).toBe('A');
  });
});
