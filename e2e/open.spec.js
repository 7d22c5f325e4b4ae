// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';

test('The page opens with the bunny loaded and a place for the code, so that Engrave is the first click', async ({ page }) => {
  /** @type {string[]} */ const complaints = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  await expect(app.sample).toHaveValue('bunny');
  await expect(app.facts).toHaveText('Stanford bunny, 102.8 × 77.9 × 100.0 mm');
  await expect(page.locator('#model-facts')).toHaveText('14,696 triangles');
  await expect(app.text).not.toHaveValue('');
  await expect(app.canvas).toBeVisible();
  expect(complaints).toEqual([]);
});

test('Nothing is asked of any other place than the one the page came from', async ({ page, baseURL }) => {
  /** @type {string[]} */ const elsewhere = [];
  page.on('request', (request) => {
    if (!request.url().startsWith(/** @type {string} */ (baseURL)) && !request.url().startsWith('data:')) elsewhere.push(request.url());
  });
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  expect(elsewhere).toEqual([]);
  await expect(page.locator('meta[http-equiv="Content-Security-Policy"]')).toHaveAttribute('content', /default-src 'none'/);
});

test('The page does not scroll sideways', async ({ page }) => {
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  await app.openSettings();
  const overflow = await page.evaluate(() => ['html', '#panel'].map((selector) => {
    const element = /** @type {Element} */ (document.querySelector(selector));
    return element.scrollWidth - element.clientWidth;
  }));
  expect(overflow).toEqual([0, 0]);
});

for (const sample of ['bumpy-sphere', 'vase', 'star', 'pyramid', 'saddle', 'plate']) {
  test(`The sample ${sample} finds a place of at least 20 mm for its code`, async ({ page }) => {
    const app = new Engraver(page);
    await app.open(`?sample=${sample}`);
    await app.expectReady();
    await expect(app.sample).toHaveValue(sample);
    const width = Number(/^([\d.]+) mm wide/.exec((await app.placement.textContent()) ?? '')?.[1]);
    expect(width).toBeGreaterThanOrEqual(20);
  });
}
