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

const kInspector = /inspector.*\.wasm$/;

test('The page is usable after at most 1.5 MB; decoder, inspector and message words load later', async ({ page }) => {
  const app = new Engraver(page);
  const inspector = new Inspector(page);
  await page.goto(site.address);
  await app.expectReady();
  const bytes = site.sent.reduce((sum, file) => sum + file.bytes, 0);
  console.log(`first load: ${(bytes / 1e6).toFixed(2)} MB by gzip in ${site.sent.length} files`);
  expect(site.sent.map(({ path }) => path)).toContain('samples/bunny.stl');
  expect(site.sent.filter(({ path }) => /reader|inspector|message_catalogues/.test(path))).toEqual([]);
  expect(bytes).toBeLessThan(1.5e6);

  await test.step('a failure to load the inspector is reported, and pressing again retries', async () => {
    await app.sample.selectOption('Saddle'); // quick to engrave
    await expect(app.facts).toContainText('Saddle');
    await app.expectReady();
    site.lacks = (path) => kInspector.test(path);
    await inspector.button.click();
    await expect(app.alert).toContainText('The inspector could not be loaded (404');
    await expect(inspector.button).toHaveAttribute('aria-pressed', 'false');
    expect(await inspector.state()).toBeUndefined();
    await page.getByRole('button', { name: 'Dismiss' }).click();
    await app.engrave(); // everything else still works

    site.lacks = () => false;
    await inspector.open();
    await inspector.expectState((state) => state.passes > 1, true);
    const loaded = site.sent.filter(({ path }) => kInspector.test(path));
    expect(loaded.length).toBe(1);
    console.log(`the inspector: ${(loaded[0].bytes / 1e6).toFixed(2)} MB by gzip`);
  });
});

test('Message words load with the first message, in its language; a failure is reported', async ({ page }) => {
  const words = () => site.sent.filter(({ path }) => /message_catalogues/.test(path));
  const app = new Engraver(page);
  await page.goto(site.address);
  await app.expectReady();
  site.lacks = (path) => /message_catalogues/.test(path);
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
