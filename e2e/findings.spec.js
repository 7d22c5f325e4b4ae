// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { writeStl } from '../web/samples/stl.js';
import { Engraver } from './support/engraver.js';
import { saddleMesh } from './support/models.js';

test('A model in metres is called tiny in the page’s words, and one click reads it in a unit that makes it printable', async ({ page }) => {
  const positions = saddleMesh.positions.map((point) => /** @type {[number, number, number]} */ (point.map((v) => v / 1000)));
  const buffer = Buffer.from(writeStl({ ...saddleMesh, positions }, 'in metres'));
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  await app.file.setInputFiles({ name: 'metres.stl', mimeType: 'model/stl', buffer });
  const findings = page.getByRole('list', { name: 'Found in the model' });
  await expect(findings).toContainText('The model is tiny: 0.09 × 0.09 × 0.04 mm. If it should be larger, choose another unit: in metres it is 90 × 90 × 40 mm.');
  await expect(findings).not.toContainText('--');
  await findings.getByRole('button', { name: 'Read it in metres: 90 × 90 × 40 mm' }).click();
  await expect(app.facts).toHaveText('metres.stl, 90.0 × 90.0 × 40.0 mm');
  await expect(findings.getByRole('listitem')).toHaveCount(0);
  await app.expectReady();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(app.facts).toHaveText(/metres\.stl, 0\.09/);
});
