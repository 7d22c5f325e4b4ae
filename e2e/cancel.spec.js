// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { wavySphereStl } from './support/big_model.js';
import { Engraver } from './support/engraver.js';
import { holdWorkers } from './support/workers.js';

/** @typedef {import('@playwright/test').Page} Page */

const kCancelled = /^Cancelled\./;

/**
 * Clicks Cancel in the page at the moment the status shows the stage, and measures until the status says it is cancelled
 * and Cancel is gone. The clock is the page's own: the test's way to the page takes longer than what is measured.
 * @param {Page} page
 * @param {string} stage  what the status begins with
 * @returns {Promise<number>}  ms
 */
const cancelAt = (page, stage) => page.evaluate(([begin, cancelled]) => new Promise((resolve) => {
  const status = /** @type {HTMLElement} */ (document.querySelector('[role="status"]'));
  const button = /** @type {HTMLElement} */ ([...document.querySelectorAll('button')].find(({ textContent }) => textContent?.trim() === 'Cancel'));
  let clicked = 0;
  const look = () => {
    const words = status.textContent ?? '';
    if (clicked === 0 && words.startsWith(begin) && button.offsetParent !== null) {
      clicked = performance.now();
      button.click();
    } else if (clicked > 0 && new RegExp(cancelled).test(words) && button.offsetParent === null) {
      observer.disconnect();
      resolve(performance.now() - clicked);
    }
  };
  const observer = new MutationObserver(look);
  observer.observe(document.body, { childList: true, characterData: true, attributes: true, subtree: true });
  look();
}), [stage, kCancelled.source]);

const kStages = ['Preparing', 'Measuring the surface', 'Finding the depth', 'Carving the mesh',
  'Checking the solid', 'Looking at the result'];

test('Cancel is obeyed within 250 ms at every stage, and nothing is lost', async ({ page }) => {
  const app = new Engraver(page);
  await page.addInitScript(holdWorkers);
  await app.open('?sample=saddle&text=cancelled%20often');
  await page.evaluate(() => {
    /** @type {any} */ (window).skipped = ['prepareEngrave'];  // else the page begins the carving before it is asked to
  });
  await app.expectReady();
  const centre = await app.centre();
  /** @type {string[]} */ const measured = [];
  for (const stage of kStages) {
    const time = cancelAt(page, stage);
    await app.engraveButton.click();
    const ms = await time;
    measured.push(`${stage} ${ms.toFixed(0)} ms`);
    expect(ms, stage).toBeLessThan(250);
    await expect(app.result).toBeHidden();
    await expect(app.engraveButton).toBeEnabled();
  }
  console.log(`cancel: ${measured.join(', ')}`);
  expect(await app.centre()).toEqual(centre);
  await app.engrave();
  await expect(app.result).toContainText('Reads as cancelled often');
});

test('Cancel is obeyed while the code still looks for its place', async ({ page }) => {
  const app = new Engraver(page);
  await page.addInitScript(holdWorkers);
  await app.open('?sample=saddle');
  await app.expectReady();
  await page.evaluate(() => {
    /** @type {any} */ (window).unheard = ['placement'];  // it takes as long as one likes
  });
  await app.text.fill('another text');
  const time = cancelAt(page, 'Preparing');
  await app.engraveButton.click();
  expect(await time).toBeLessThan(250);
  await expect(app.result).toBeHidden();
  await expect(app.engraveButton).toBeEnabled();
});

test('Cancel stops the search for spots within 250 ms', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  const time = cancelAt(page, 'Looking for spots');
  await page.getByRole('button', { name: 'Suggest spots' }).click();
  expect(await time).toBeLessThan(250);
  await app.suggest();
  await expect(app.spots).not.toHaveCount(0);
});

test('Cancel stops the reading of a file within 250 ms, and the model before it stays', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  const time = cancelAt(page, 'Reading big.stl');
  await app.file.setInputFiles({ name: 'big.stl', mimeType: 'model/stl', buffer: wavySphereStl(200) });
  expect(await time).toBeLessThan(250);
  await app.expectReady();
  await expect(app.facts).toContainText('90.0 × 90.0 × 40.0 mm');
  await app.engrave();
});
