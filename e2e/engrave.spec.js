// SPDX-License-Identifier: GPL-3.0-or-later
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test } from '@playwright/test';
import { bounds, checkSolid, volume } from '../web/samples/solid.js';
import { readStl } from '../web/samples/stl.js';
import { decodePng } from './support/decode.js';
import { Engraver } from './support/engraver.js';
import { saddleFile, saddleMesh } from './support/models.js';
import { poll } from './support/poll.js';
import { bodiesOf, extrudersOf, itemsOf, unzip } from './support/three_mf.js';

/** @typedef {import('../web/samples/solid.js').Mesh} Mesh */

const kCommand = fileURLToPath(new URL('../build/release/bin/qrelief', import.meta.url));
const kText = 'https://example.org/a/longer/text/x'; // 35 bytes: version 3-M

/** Checks the properties of every engraved solid. @param {Mesh} before @param {Mesh} after @param {any} report */
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
    // The code may cut off the model's outermost point.
    const lost = [boxAfter.min[axis] - boxBefore.min[axis], boxBefore.max[axis] - boxAfter.max[axis]];
    for (const mm of lost) {
      expect(mm).toBeGreaterThan(-1e-4);
      expect(mm).toBeLessThan(0.2);
    }
  }
  const keysBefore = triangleKeys(before);
  const unchanged = [...triangleKeys(after)].filter((key) => keysBefore.has(key)).length;
  expect(unchanged).toBeGreaterThanOrEqual(report.mesh.keptTriangles);
}

/** Returns the triangles by their exact coordinates, each starting at its smallest corner. @param {Mesh} mesh */
function triangleKeys(mesh) {
  return new Set(
    mesh.triangles.map((corners) => {
      const words = corners.map((corner) => mesh.positions[corner].map(Math.fround).join(' '));
      const first = words.indexOf([...words].sort()[0]);
      return [0, 1, 2].map((i) => words[(first + i) % 3]).join(' | ');
    }),
  );
}

/** @param {number[]} a @param {number[]} b @returns degrees */
function angleBetween(a, b) {
  const dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return (Math.acos(Math.min(1, dot)) * 180) / Math.PI;
}

test('The engraved bunny decodes inside and outside the page and downloads as a solid', async ({ page }, testInfo) => {
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  const stl = await (await page.request.get('samples/bunny.stl')).body();
  await app.text.fill(kText);
  await app.engrave();

  await expect(app.result).toContainText(`Reads as ${kText}`);
  await expect(app.result).toContainText(/Size\s*[\d.]+\smm, modules of\s[\d.]+\smm/);
  await expect(app.result).toContainText(/Depth\s*[\d.]+\smm on average, [\d.]+\smm at most/);
  await expect(app.result).toContainText(/Time\s*[\d.]+\ss/);
  console.log(`bunny: ${(await app.result.locator('dl').innerText()).replaceAll('\n', ' ')}`);

  const report = await app.report();
  expect(report.text).toBe(kText);
  expect(report.verification.text).toBe(kText);
  const { name, bytes } = await app.download();
  expect(name).toMatch(/^bunny-qr-example\.org-\d+mm\.stl$/);
  expectEngravedSolid(readStl(new Uint8Array(stl)), readStl(bytes), report);

  await page.getByRole('button', { name: 'Phone view' }).click();
  await poll(async () => decodePng(await app.canvas.screenshot())).toBe(kText);

  // One core, compiled twice. Light may come from shaders or the processor: the results must agree within a tolerance.
  await test.step('The page and the command carve the same', async () => {
    const [model, reported] = [testInfo.outputPath('bunny.stl'), testInfo.outputPath('report.json')];
    writeFileSync(model, stl);
    const at = report.projection.centre.join(',');
    execFileSync(kCommand, [
      'engrave',
      model,
      '--text',
      kText,
      `--at=${at}`,
      '-o',
      testInfo.outputPath('carved.stl'),
      '--report',
      reported,
      '--quiet',
    ]);
    const native = JSON.parse(readFileSync(reported, 'utf8'));
    console.log(
      `page ${report.gl.renderer}: ${JSON.stringify(report.depth)}; command ${native.gl.renderer}: ${JSON.stringify(native.depth)}`,
    );
    expect(report.symbol).toEqual(native.symbol);
    expect(angleBetween(report.projection.normal, native.projection.normal)).toBeLessThan(0.5);
    expect(Math.abs(report.size.symbolMm / native.size.symbolMm - 1)).toBeLessThan(0.01);
    const halfLayerMm = native.depth.features.layerMm / 2;
    expect(Math.abs(report.depth.meanMm - native.depth.meanMm)).toBeLessThan(0.002);
    expect(Math.abs(report.depth.maxMm - native.depth.maxMm)).toBeLessThan(halfLayerMm);
    expect(Math.abs(report.mesh.volumeMm3 / native.mesh.volumeMm3 - 1)).toBeLessThan(1e-4);
  });
});

test('With the user’s own file, a picked point and changed settings, the result is a solid', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=pyramid');
  await app.expectReady();
  await app.file.setInputFiles(saddleFile);
  await expect(app.facts).toHaveText('my saddle.stl, 90.0 × 90.0 × 40.0 mm');
  await app.expectReady();
  const proposed = await app.centre();
  const box = /** @type {{ width: number, height: number }} */ (await app.canvas.boundingBox());
  await app.canvas.click({ position: { x: box.width / 2 + 40, y: box.height / 2 } });
  await poll(() => app.centre()).not.toEqual(proposed);
  await app.expectReady();

  await app.openSettings();
  await app.setting('Size of the code').selectOption('Exactly');
  await app.setting('Width (mm)').fill('25');
  await app.setting('Modules').selectOption('Full');
  await app.setting('Nozzle (mm)').fill('1.8');
  await expect(app.placement).toContainText('25.0 mm wide');
  await app.expectReady();
  await app.engrave();
  const report = await app.report();
  expect(report.size.symbolMm).toBeCloseTo(25, 9);
  await expect(app.result.getByRole('list', { name: 'Verdict' })).toContainText('a 1.8 mm nozzle, choose modules of');
  await expect(app.setting('Format')).toHaveValue('stl');
  const { name, bytes } = await app.download();
  expect(name).toBe('my-saddle-qr-en.wikipedia.org-25mm.stl');
  expectEngravedSolid(saddleMesh, readStl(bytes), report);

  await test.step('In two colours, the model and its inlay are two solids that every slicer distinguishes', async () => {
    await app.setting('Format').selectOption('3MF, two colours');
    const inlaid = await app.download();
    expect(inlaid.name).toBe('my-saddle-qr-en.wikipedia.org-25mm-inlay.3mf');
    expectTwoColours(inlaid.bytes, report);
  });

  await test.step('The chosen format is kept after a reload', async () => {
    await page.reload();
    await expect(app.setting('Format')).toHaveValue('3mf-inlay');
  });
});

/** @param {Uint8Array} bytes  of the 3MF file @param {any} report */
function expectTwoColours(bytes, report) {
  const files = unzip(bytes);
  const model = files.get('3D/3dmodel.model') ?? '';
  expect(model).toMatch(/<model unit="millimeter"[^>]* requiredextensions="m"/);
  const bodies = bodiesOf(model);
  const [bodyId, inlayId] = [...bodies.keys()];
  expect(bodies.size).toBe(2);
  expect(itemsOf(model)).toEqual([[bodyId, inlayId]]); // one object on the plate
  const [body, inlay] = [...bodies.values()];
  expect(inlay.name).toBe('QR code');

  for (const { mesh } of [body, inlay]) {
    expect(checkSolid(mesh)).toMatchObject({
      openEdges: 0,
      nonManifoldEdges: 0,
      nonManifoldVertices: 0,
      degenerateTriangles: 0,
    });
  }
  expect(volume(body.mesh) / report.mesh.volumeMm3).toBeCloseTo(1, 6);
  expect((volume(body.mesh) + volume(inlay.mesh)) / volume(saddleMesh)).toBeCloseTo(1, 6);

  expect(body.colour).toMatch(/^#[0-9A-F]{6}FF$/);
  expect(inlay.colour).toMatch(/^#[0-9A-F]{6}FF$/);
  expect(inlay.colour).not.toBe(body.colour);
  expect([body.cura, inlay.cura]).toEqual(['0', '1']);
  const extruders = { [bodyId]: '1', [inlayId]: '2' };
  expect(extrudersOf(files)).toEqual({ bambu: extruders, prusa: extruders });
}
