// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { checkSolid, volume } from '../web/samples/solid.js';
import { Engraver } from './support/engraver.js';
import { saddleFile, saddleMesh } from './support/models.js';
import { bodiesOf, extrudersOf, itemsOf, unzip } from './support/three_mf.js';

test('In two colours, the model and what fills its pockets are two solids that every slicer tells apart', async ({ page }) => {
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  await app.file.setInputFiles(saddleFile);
  await expect(app.facts).toContainText('my saddle.stl');
  await app.expectReady();
  await app.engrave();
  await app.setting('Format').selectOption('3MF, two colours');
  const { name, bytes } = await app.download();
  expect(name).toMatch(/^my-saddle-qr-.*mm-inlay\.3mf$/);

  const files = unzip(bytes);
  const model = files.get('3D/3dmodel.model') ?? '';
  expect(model).toMatch(/<model unit="millimeter"[^>]* requiredextensions="m"/);
  const bodies = bodiesOf(model);
  const [bodyId, inlayId] = [...bodies.keys()];
  expect(bodies.size).toBe(2);
  expect(itemsOf(model)).toEqual([[bodyId, inlayId]]);  // one thing on the plate
  const [body, inlay] = [...bodies.values()];
  expect(inlay.name).toBe('QR code');

  for (const { mesh } of [body, inlay]) {
    expect(checkSolid(mesh)).toMatchObject({ openEdges: 0, nonManifoldEdges: 0, nonManifoldVertices: 0, degenerateTriangles: 0 });
  }
  const report = await app.report();
  expect(volume(body.mesh) / report.mesh.volumeMm3).toBeCloseTo(1, 6);
  expect((volume(body.mesh) + volume(inlay.mesh)) / volume(saddleMesh)).toBeCloseTo(1, 6);

  expect(body.colour).toMatch(/^#[0-9A-F]{6}FF$/);
  expect(inlay.colour).toMatch(/^#[0-9A-F]{6}FF$/);
  expect(inlay.colour).not.toBe(body.colour);
  expect([body.cura, inlay.cura]).toEqual(['0', '1']);
  const extruders = { [bodyId]: '1', [inlayId]: '2' };
  expect(extrudersOf(files)).toEqual({ bambu: extruders, prusa: extruders });
});
