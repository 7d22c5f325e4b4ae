// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { Inspector } from './support/inspector.js';
import { truncatedFile } from './support/models.js';
import { Site } from './support/site.js';

/** @type {Site} */ let site;
test.beforeEach(async () => {
  site = await new Site('/').open();
});
test.afterEach(() => site.close());

test('The page is usable after at most 1.57 MB; decoder and message words load later', async ({ page }) => {
  const app = new Engraver(page);
  await page.goto(site.address);
  await app.expectReady();
  const bytes = site.sent.reduce((sum, file) => sum + file.bytes, 0);
  console.log(`first load: ${(bytes / 1e6).toFixed(2)} MB by gzip in ${site.sent.length} files`);
  expect(site.sent.map(({ path }) => path)).toContain('samples/bunny.stl');
  expect(site.sent.filter(({ path }) => /reader|-messages-/.test(path))).toEqual([]);
  expect(bytes).toBeLessThan(1.57e6);
});

test('Message words load with the first message, in its language; a failure is reported', async ({ page }) => {
  const words = () => site.sent.filter(({ path }) => /-messages-/.test(path));
  const app = new Engraver(page);
  await page.goto(site.address);
  await app.expectReady();
  site.lacks = (path) => /-messages-/.test(path);
  await app.file.setInputFiles(truncatedFile);
  await expect(app.alert).toContainText('could not be loaded; check your connection');
  expect(words()).toEqual([]);

  site.lacks = () => false;
  await page.getByRole('combobox', { name: 'Language' }).selectOption('Deutsch');
  await expect(app.alert).toContainText(/Dreieck/);
  expect(words().length).toBe(1);
  console.log(`the words of messages: ${(words()[0].bytes / 1e3).toFixed(1)} kB by gzip`);
});

test('The page works from a host that does not know WebAssembly’s MIME type', async ({ page }) => {
  site.types['.wasm'] = 'application/octet-stream';
  const app = new Engraver(page);
  await page.goto(`${site.address}?sample=pyramid`);
  await app.expectReady();
  await new Inspector(page).open();
  await expect(app.alert).toHaveCount(0);
});
