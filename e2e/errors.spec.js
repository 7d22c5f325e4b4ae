// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { holdWorkers } from './support/workers.js';
import { openFile, saddleFile, truncatedFile } from './support/models.js';

test('A truncated file is refused with both sizes, and the model before it stays', async ({ page }) => {
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  await app.file.setInputFiles(truncatedFile);
  await expect(app.alert).toContainText('10000');
  await expect(app.alert).toContainText(String(saddleFile.buffer.length));
  await expect(app.facts).toHaveText('Stanford bunny, 102.8 × 77.9 × 100.0 mm');
  await expect(app.engraveButton).toBeEnabled();
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await expect(app.alert).toHaveCount(0);
});

test('A model with a hole is refused with the number of open edges', async ({ page }) => {
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  await app.file.setInputFiles(openFile);
  await expect(app.alert).toContainText(/3 .*edge/i);
});

test('A file dropped on the page is opened', async ({ page }) => {
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  await app.canvas.drop({ files: saddleFile });
  await expect(app.facts).toContainText('my saddle.stl');
  await expect(page.getByText('Drop the model to open it')).toBeHidden();
});

test('Another unit makes the model larger by its factor', async ({ page }) => {
  const app = new Engraver(page);
  await app.open();
  await app.file.setInputFiles(saddleFile);
  await expect(app.facts).toContainText('90.0 × 90.0 × 40.0 mm');
  await app.openSettings();
  await app.setting('Unit').selectOption('inch');
  await expect(app.facts).toContainText('2,286.0 × 2,286.0 × 1,016.0 mm');
});

test('An empty text and a code that is too large are refused in words', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  await app.text.fill('');
  await expect(app.alert).toContainText(/text/i);
  await app.text.fill('short');
  await app.expectReady();
  await expect(app.alert).toHaveCount(0);
  await app.openSettings();
  await app.setting('Size of the code').selectOption('Exactly');
  await app.setting('Width (mm)').fill('200');
  await app.setting('Width (mm)').blur();
  await expect(app.alert).toContainText(/mm/);
  await app.engraveButton.click();
  await expect(app.result).toBeHidden();
});

test('A setting out of its range is named with its range', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  await app.openSettings();
  await app.setting('Distance (mm)').fill('3');
  await app.setting('Distance (mm)').blur();
  await expect(app.alert).toContainText('“Distance” must be a number from 20 to 100000, not 3');
});

test('An unknown sample is named together with those there are', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=teapot');
  await expect(app.alert).toContainText('There is no sample “teapot”');
  await expect(app.alert).toContainText('bunny, bumpy-sphere, vase, star, pyramid, saddle, plate');
});

test('A browser without WebGL 2 is told so', async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(HTMLCanvasElement.prototype, 'transferControlToOffscreen', { value: undefined });
    delete /** @type {any} */ (HTMLCanvasElement.prototype).transferControlToOffscreen;
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  const app = new Engraver(page);
  await app.open();
  await expect(app.alert).toContainText('This browser offers no WebGL 2');
  await expect(app.engraveButton).toBeDisabled();
});

test('A browser without WebAssembly is told so', async ({ page }) => {
  await page.addInitScript(() => {
    delete /** @type {any} */ (window).WebAssembly;
  });
  const app = new Engraver(page);
  await app.open();
  await expect(app.alert).toContainText('WebAssembly');
  await expect(app.engraveButton).toBeDisabled();
});

test('A browser that gives the work too little memory says so, and the model before stays', async ({ page }) => {
  await page.addInitScript(holdWorkers);
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=kept');
  await app.expectReady();
  await page.evaluate(() => /** @type {any} */ (window).failNext('configure', { kind: 'Internal', code: 'out-of-memory', values: {} }));
  await app.text.fill('more');
  await expect(app.alert).toContainText('no more memory');
  await expect.poll(() => page.evaluate(() => /** @type {any} */ (window).workers.length)).toBe(2);
  await app.expectReady();
  await expect(app.text).toHaveValue('more');
});
