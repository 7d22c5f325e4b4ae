// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';

test.use({ deviceScaleFactor: 1 }); // on a phone, too: no test here looks at the screen’s pixels

test('The page opens with the bunny and a placed code, ready to engrave', async ({ page, baseURL }) => {
  /** @type {string[]} */ const complaints = [];
  /** @type {string[]} */ const elsewhere = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  page.on('request', (request) => {
    if (!request.url().startsWith(/** @type {string} */ (baseURL)) && !request.url().startsWith('data:'))
      elsewhere.push(request.url());
  });
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  await expect(app.sample).toHaveValue('bunny');
  await expect(app.facts).toHaveText('Stanford bunny, 102.8 × 77.9 × 100.0 mm');
  await expect(page.locator('#model-facts')).toHaveText('14,696 triangles');
  await expect(app.text).not.toHaveValue('');
  await expect(app.canvas).toBeVisible();

  await test.step('all requests go to the page’s own origin', async () => {
    expect(elsewhere).toEqual([]);
    await expect(page.locator('meta[http-equiv="Content-Security-Policy"]')).toHaveAttribute(
      'content',
      /default-src 'none'/,
    );
  });
  await test.step('it does not scroll sideways', async () => {
    await app.openSettings();
    const overflow = await page.evaluate(() =>
      ['html', '#panel'].map((selector) => {
        const element = /** @type {Element} */ (document.querySelector(selector));
        return element.scrollWidth - element.clientWidth;
      }),
    );
    expect(overflow).toEqual([0, 0]);
  });
  expect(complaints).toEqual([]);
});

test('The code gets at least 20 mm on every sample', { tag: '@desktop' }, async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=plate');
  await app.expectReady();
  await expect(app.sample).toHaveValue('plate');
  const ids = await app.sample
    .locator('option')
    .evaluateAll((all) => all.map((option) => /** @type {HTMLOptionElement} */ (option).value));
  expect(ids).toEqual(['bunny', 'owl', 'pawn', 'bumpy-sphere', 'vase', 'star', 'pyramid', 'saddle', 'plate']);
  expect(await app.width()).toBeGreaterThanOrEqual(20);
  for (const id of ids) {
    await test.step(`The sample ${id} finds a place of at least 20 mm for its code`, async () => {
      const before = await app.facts.innerText();
      await app.sample.selectOption(id);
      await expect(app.facts).not.toHaveText(before); // each has its own name
      await app.expectReady();
      expect(await app.width()).toBeGreaterThanOrEqual(20);
    });
  }
});
