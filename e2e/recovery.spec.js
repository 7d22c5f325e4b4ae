// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';

/** Gives the tests a hold of the page's workers and lets them send a worker a script of their own. */
const kHoldWorkers = () => {
  const page = /** @type {any} */ (window);
  page.workers = [];
  const Original = window.Worker;
  page.Worker = class extends Original {
    /** @param {string | URL} url @param {WorkerOptions} [options] */
    constructor(url, options) {
      super(url, options);
      page.workers.push(this);
    }
  };
};

test('A worker that crashes is replaced, with the model, the text and the centre kept', async ({ page }) => {
  await page.addInitScript(kHoldWorkers);
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
