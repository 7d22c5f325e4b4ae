// SPDX-License-Identifier: GPL-3.0-or-later
import { rmSync, writeFileSync } from 'node:fs';
import { expect, test } from '@playwright/test';
import { wavySphereStl } from './support/big_model.js';
import { Engraver } from './support/engraver.js';

test('A code engraved into a model of two million triangles decodes', async ({ page }, testInfo) => {
  test.setTimeout(600_000);
  const file = testInfo.outputPath('two million.stl'); // too large for Playwright to pass as a buffer
  writeFileSync(file, wavySphereStl(708));
  const app = new Engraver(page);
  await app.open('?sample=pyramid');
  await app.expectReady();
  await app.text.fill('large');
  const begun = Date.now();
  await app.file.setInputFiles(file);
  await expect(app.facts).toContainText('two million.stl', { timeout: 200_000 });
  await expect(page.locator('#model-facts')).toHaveText('2,002,224 triangles');
  const opened = Date.now();
  await expect(app.status).toHaveText(/^Ready\./, { timeout: 200_000 });
  const placed = Date.now();
  await app.engraveButton.click();
  await expect(app.result).toContainText('Reads as large', { timeout: 300_000 });
  console.log(
    `2,002,224 triangles: opened in ${opened - begun} ms, placed in ${placed - opened} ms, engraved in ${Date.now() - placed} ms`,
  );
  rmSync(file);
});
