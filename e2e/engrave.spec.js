// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { bounds, checkSolid, volume } from '../web/samples/solid.js';
import { readStl } from '../web/samples/stl.js';
import { decodePng } from './support/decode.js';
import { Engraver } from './support/engraver.js';
import { saddleFile, saddleMesh } from './support/models.js';

/** @typedef {import('../web/samples/solid.js').Mesh} Mesh */

const kText = 'https://example.org/a/longer/text/x';  // 35 bytes: version 3-M

/** What every engraved solid must be. @param {Mesh} before @param {Mesh} after @param {any} report */
function expectEngravedSolid(before, after, report) {
  const check = checkSolid(after);
  expect(check).toMatchObject({ openEdges: 0, nonManifoldEdges: 0, nonManifoldVertices: 0, degenerateTriangles: 0 });
  expect(after.triangles.length).toBe(report.mesh.triangles);
  const removed = volume(before) - check.volume;
  expect(check.volume / report.mesh.volumeMm3).toBeCloseTo(1, 6);
  expect(removed).toBeGreaterThan(0);
  expect(removed).toBeLessThan(report.depth.maxMm * report.size.symbolMm ** 2);
  const [boxBefore, boxAfter] = [bounds(before), bounds(after)];
  for (const axis of [0, 1, 2]) {
    expect(boxAfter.min[axis]).toBeCloseTo(boxBefore.min[axis], 4);
    expect(boxAfter.max[axis]).toBeCloseTo(boxBefore.max[axis], 4);
  }
  const kept = triangleKeys(before);
  const found = [...triangleKeys(after)].filter((key) => kept.has(key)).length;
  expect(found).toBeGreaterThanOrEqual(report.mesh.keptTriangles);
}

/** Triangles by their exact coordinates, the smallest corner first. @param {Mesh} mesh */
function triangleKeys(mesh) {
  return new Set(mesh.triangles.map((corners) => {
    const words = corners.map((corner) => mesh.positions[corner].map(Math.fround).join(' '));
    const first = words.indexOf([...words].sort()[0]);
    return [0, 1, 2].map((i) => words[(first + i) % 3]).join(' | ');
  }));
}

test('The bunny is engraved, reads as the text, inside and outside the page, and downloads as a solid', async ({ page }) => {
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  const sample = readStl(new Uint8Array(await (await page.request.get('samples/bunny.stl')).body()));
  await app.text.fill(kText);
  await app.expectReady();
  await app.engrave();

  await expect(app.result).toContainText(`Reads as ${kText}`);
  await expect(app.result).toContainText(/Size\s*[\d.]+ mm, modules of [\d.]+ mm/);
  await expect(app.result).toContainText(/Depth\s*[\d.]+ mm on average, [\d.]+ mm at most/);
  await expect(app.result).toContainText(/Time\s*[\d.]+ s/);
  console.log(`bunny: ${(await app.result.locator('dl').innerText()).replaceAll('\n', ' ')}`);

  const report = await app.report();
  expect(report.text).toBe(kText);
  expect(report.verification.text).toBe(kText);
  const { name, bytes } = await app.download();
  expect(name).toMatch(/^bunny-qr-example\.org-\d+mm\.stl$/);
  expectEngravedSolid(sample, readStl(bytes), report);

  await page.getByRole('button', { name: 'Reader’s view' }).click();
  await expect.poll(async () => decodePng(await app.canvas.screenshot()), { timeout: 60_000 }).toBe(kText);
});

test('A file of one’s own is opened, a point picked, settings changed, and the result is a solid', async ({ page }) => {
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  await app.file.setInputFiles(saddleFile);
  await expect(app.facts).toHaveText('my saddle.stl, 90.0 × 90.0 × 40.0 mm');
  await app.expectReady();
  const proposed = await app.centre();
  const box = /** @type {{ width: number, height: number }} */ (await app.canvas.boundingBox());
  await app.canvas.click({ position: { x: box.width / 2 + 40, y: box.height / 2 } });
  await expect.poll(() => app.centre()).not.toEqual(proposed);
  await app.expectReady();

  await app.openSettings();
  await app.setting('Size of the code').selectOption('Exactly');
  await app.setting('Width (mm)').fill('25');
  await app.setting('Modules').selectOption('Full');
  await app.setting('Nozzle (mm)').fill('1.2');
  await expect(app.placement).toContainText('25.0 mm wide');
  await app.expectReady();
  await app.engrave();
  const report = await app.report();
  expect(report.size.symbolMm).toBeCloseTo(25, 9);
  await expect(app.result.getByRole('list', { name: 'Verdict' })).toContainText('1.2 mm nozzle: choose a module of');
  const { name, bytes } = await app.download();
  expect(name).toBe('my-saddle-qr-en.wikipedia.org-25mm.stl');
  expectEngravedSolid(saddleMesh, readStl(bytes), report);
});

test('A click elsewhere moves the centre, a drag turns the model and leaves the centre where it is', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=bumpy-sphere');
  await app.expectReady();
  const before = await app.centre();
  const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await app.canvas.boundingBox());
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 20, { steps: 6 });
  await page.mouse.up();
  expect(await app.centre()).toEqual(before);

  await page.mouse.click(x, y);
  await expect.poll(() => app.centre()).not.toEqual(before);
  await app.expectReady();
  const [cx, cy, cz] = await app.centre();
  expect(Math.abs(Math.hypot(cx, cy, cz - 50) - 48)).toBeLessThan(2.6);  // on the bumpy sphere
});

test('The keyboard alone turns the model, places the code and engraves', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=bumpy-sphere');
  await app.expectReady();
  const before = await app.centre();
  await app.canvas.focus();
  for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowLeft', '+', 'Enter']) await page.keyboard.press(key);
  await expect.poll(() => app.centre()).not.toEqual(before);
  await app.expectReady();
  await app.engraveButton.focus();
  await page.keyboard.press('Enter');
  await app.expectResult();
});

test('Cancel stops the work at once and leaves the model ready to be engraved', async ({ page }) => {
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  await app.engraveButton.click();
  await expect(app.progress).toBeVisible();
  await expect(app.progress).toHaveAccessibleName(/\S/);
  await expect(app.status).not.toHaveText('Preparing…');
  const clicked = Date.now();
  await app.cancelButton.click();
  await expect(app.status).toHaveText('Cancelled. The model is as it was.');
  console.log(`cancel: ${Date.now() - clicked} ms`);
  await expect(app.progress).toBeHidden();
  await expect(app.result).toBeHidden();
  await app.engrave();
  await expect(app.result).toContainText('Reads as');
});

test('The address alone opens a sample with a text and engraves it', async ({ page }) => {
  const app = new Engraver(page);
  await app.open(`?sample=saddle&text=${encodeURIComponent('Grüße ☕')}&engrave=1`);
  await app.expectResult();
  await expect(app.text).toHaveValue('Grüße ☕');
  await expect(app.result).toContainText('Reads as Grüße ☕');
});

test('After a change the result says that it is older than the settings', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle&engrave=1');
  await app.expectResult();
  await expect(app.result).not.toContainText('Engrave again');
  await app.text.fill('another text');
  await expect(app.result).toContainText('Made before your last change. Engrave again to update it.');
});
