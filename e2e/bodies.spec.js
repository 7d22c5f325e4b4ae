// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';

/** Returns a box as OBJ; its vertices are numbered from `first`. */
function boxAsObj(
  /** @type {[number, number, number]} */ [x, y, z],
  /** @type {[number, number, number]} */ [w, d, h],
  /** @type {number} */ first,
) {
  const corners = [0, 1].flatMap((k) => [0, 1].flatMap((j) => [0, 1].map((i) => [x + i * w, y + j * d, z + k * h])));
  const faces = ['0 2 3 1', '4 5 7 6', '0 1 5 4', '2 6 7 3', '0 4 6 2', '1 3 7 5'];
  return [
    ...corners.map((corner) => `v ${corner.join(' ')}`),
    ...faces.map(
      (face) =>
        `f ${face
          .split(' ')
          .map((v) => Number(v) + first)
          .join(' ')}`,
    ),
  ].join('\n');
}

test('The bodies of a model are listed, a click shows one, and the code goes into one of them', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=plate');
  await app.expectReady();
  const bodies = page.getByRole('group', { name: 'Show a body in the view' });
  await expect(bodies).toBeHidden();

  // A plate with a block on it: their faces touch.
  const plate = boxAsObj([0, 0, 0], [60, 40, 4], 1);
  const block = boxAsObj([48, 4, 4], [8, 8, 8], 9);
  await app.file.setInputFiles({
    name: 'two.obj',
    mimeType: 'model/obj',
    buffer: Buffer.from(`o plate\n${plate}\no block\n${block}\n`),
  });
  await expect(bodies.getByRole('button')).toHaveText(['plate', 'block']);
  await expect(app.alert).toHaveCount(0);

  const { canvas } = app;
  const before = await canvas.screenshot();
  await bodies.getByRole('button', { name: 'block' }).click();
  await expect.poll(async () => (await canvas.screenshot()).equals(before)).toBe(false);

  await app.suggest();
  await app.spots.first().click();
  await app.engrave();
  const { mesh } = await app.report();
  expect(mesh.bodies).toBe(2);
  expect(mesh.carvedBodyName).toBe('plate');
  expect(mesh.closed && mesh.manifold).toBe(true);
});
