// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { holdWorkers } from './support/workers.js';

test('A worker that crashes is replaced, with the model, the text and the centre kept', async ({ page }) => {
  await page.addInitScript(holdWorkers);
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=kept');
  await app.expectReady();
  const centre = await app.centre();
  await page.evaluate(() => {
    const [worker] = /** @type {any} */ (window).workers;
    worker.dispatchEvent(new ErrorEvent('error', { message: 'out of memory', cancelable: true }));
  });
  await expect(app.alert).toContainText('The engraving module stopped');
  await expect.poll(() => page.evaluate(() => /** @type {any} */ (window).workers.length)).toBe(2);
  await app.expectReady();
  expect(await app.centre()).toEqual(centre);
  await expect(app.text).toHaveValue('kept');
  await app.engraveButton.click();
  await expect(app.result).toContainText('Reads as kept');
});

test('A lost WebGL context is rebuilt', async ({ page }) => {
  await page.addInitScript(() => {
    delete /** @type {any} */ (HTMLCanvasElement.prototype).transferControlToOffscreen;  // so that the page holds the context
  });
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=again');
  await app.expectReady();
  await app.canvas.evaluate((canvas) => {
    canvas.setAttribute('data-lost', '');
    /** @type {HTMLCanvasElement} */ (canvas).getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
  });
  await expect(page.locator('canvas[data-lost]')).toHaveCount(0);  // a new one has taken its place
  await app.expectReady();
  await app.engraveButton.click();
  await expect(app.result).toContainText('Reads as again');
});

test('A lost WebGL context of the worker is rebuilt', async ({ page, browser }) => {
  await page.addInitScript(holdWorkers);
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=and%20again');
  await app.expectReady();
  const session = await browser.newBrowserCDPSession();
  await session.send('Browser.crashGpuProcess').catch(() => {});  // it answers that it crashed
  await expect.poll(() => page.evaluate(() => /** @type {any} */ (window).workers.length)).toBeGreaterThan(1);
  await app.expectReady();
  await app.engrave();
  await expect(app.result).toContainText('Reads as and again');
});

test('A worker that gives no sign of life is replaced, with everything kept', async ({ page }) => {
  await page.addInitScript(holdWorkers);
  await page.clock.install();
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=kept%20too');
  await app.expectReady();
  await page.evaluate(() => /** @type {any} */ (window).unheard.push('placement'));
  await app.openSettings();
  await app.setting('Rotation (°)').fill('10');
  await app.setting('Rotation (°)').blur();
  await page.clock.runFor(110_000);
  await expect(app.alert).toHaveCount(0);
  await page.evaluate(() => /** @type {any} */ (window).unheard.pop());
  await expect(async () => {  // an answer that was still on its way is a sign of life, and the time counts from there
    await page.clock.runFor(15_000);
    await expect(app.alert).toContainText('The engraving module has not answered for 120 seconds', { timeout: 1000 });
  }).toPass();
  await expect.poll(() => page.evaluate(() => /** @type {any} */ (window).workers.length)).toBe(2);
  await app.expectReady();
  await expect(app.setting('Rotation (°)')).toHaveValue('10');
  await expect(app.text).toHaveValue('kept too');
});

test('A worker that is busy is left alone', async ({ page }) => {
  await page.addInitScript(holdWorkers);
  await page.clock.install();
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  await page.clock.runFor(600_000);  // nothing was asked of it
  await app.engraveButton.click();
  await page.clock.runFor(600);
  await app.expectResult();
  expect(await page.evaluate(() => /** @type {any} */ (window).workers.length)).toBe(1);
});
