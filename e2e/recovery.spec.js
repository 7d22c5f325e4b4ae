// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { poll } from './support/poll.js';
import { holdWorkers } from './support/workers.js';

/** Returns the number of engine workers created so far. @param {import('@playwright/test').Page} page */
const workersOf = (page) => page.evaluate(() => /** @type {any} */ (window).workers.length);

test('A worker that crashes or runs out of memory is replaced, and nothing is lost', async ({ page }) => {
  await page.addInitScript(holdWorkers);
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=kept&process=none');
  await app.expectReady();
  await app.openSettings();
  await app.setting('Rotation (°)').fill('10');
  await app.setting('Rotation (°)').blur();
  await app.expectReady();
  const centre = await app.centre();

  await test.step('a crash', async () => {
    await page.evaluate(() => {
      const [worker] = /** @type {any} */ (window).workers;
      worker.dispatchEvent(new ErrorEvent('error', { message: 'out of memory', cancelable: true }));
    });
    await expect(app.alert).toContainText('The engraving module stopped');
    await poll(() => workersOf(page)).toBe(2);
    await app.expectReady();
    expect(await app.centre()).toEqual(centre);
    await expect(app.text).toHaveValue('kept');
    await expect(app.setting('Rotation (°)')).toHaveValue('10');
  });

  await test.step('out of memory', async () => {
    await page.evaluate(() =>
      /** @type {any} */ (window).failNext('configure', { kind: 'Internal', code: 'out-of-memory', values: {} }),
    );
    await app.text.fill('more');
    await expect(app.alert).toContainText('no more memory');
    await poll(() => workersOf(page)).toBe(3);
    await app.expectReady();
    await expect(app.text).toHaveValue('more');
  });

  await app.engrave();
  await expect(app.result).toContainText('Reads as more');
  expect((await app.report()).size.rotationDeg).toBe(10);
  expect(await app.centre()).toEqual(centre);
});

test('A lost WebGL context of the worker is rebuilt', async ({ page, browser }) => {
  await page.addInitScript(holdWorkers);
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=and%20again&process=none');
  await app.expectReady();
  const session = await browser.newBrowserCDPSession();
  await session.send('Browser.crashGpuProcess').catch(() => {}); // fails, since the browser reports the crash
  await poll(() => workersOf(page)).toBeGreaterThan(1);
  await app.expectReady();
  await app.engrave();
  await expect(app.result).toContainText('Reads as and again');
});

test('Without a worker, a lost WebGL context is rebuilt too', async ({ page }) => {
  await page.addInitScript(() => {
    delete (/** @type {any} */ (HTMLCanvasElement.prototype).transferControlToOffscreen); // the page holds the context
  });
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=again&process=none');
  await app.expectReady();
  await app.canvas.evaluate((canvas) => {
    canvas.setAttribute('data-lost', '');
    /** @type {HTMLCanvasElement} */ (canvas).getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
  });
  await expect(page.locator('canvas[data-lost]')).toHaveCount(0); // a new canvas has replaced it
  await app.expectReady();
  await app.engrave();
  await expect(app.result).toContainText('Reads as again');
});
