// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { expectNoViolations } from './support/axe.js';
import { Engraver } from './support/engraver.js';
import { poll } from './support/poll.js';

test('The app carves a code of the gallery with its settings', async ({ page }) => {
  await page.goto('./gallery.html');
  await expect(page.getByRole('heading', { name: 'Stanford bunny' })).toBeVisible();
  expect(await page.locator('.in-en .exhibit').count()).toBe(9 * 2 + 2 * 25);
  const first = page.locator('.in-en .exhibit img').first();
  await poll(() => first.evaluate((image) => /** @type {HTMLImageElement} */ (image).naturalWidth)).toBeGreaterThan(0);
  expect(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth)).toBe(
    0,
  );
  await page.getByRole('heading', { name: 'Every pattern of modules and finders' }).first().click();
  await expectNoViolations(page, 'gallery');
  await page.locator('.in-en .matrix .exhibit').filter({ hasText: 'Diamond / Thick plus, sharp' }).first().click();
  const app = new Engraver(page);
  await app.expectResult();
  await expect(page.locator('[data-setting="pattern"]')).toHaveValue('diamond');
  await expect(page.locator('[data-setting="finderPattern"]')).toHaveValue('thick-plus-sharp');
  const { depth } = await app.report();
  expect(depth.meanMm).toBeLessThan(0.6); // the default carves deeper
});

test('An invalid setting in the address is reported, and nothing is carved', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=plate&pattern=star&engrave=1');
  await expect(app.placement).toContainText('mm wide');
  await expect(app.status).toHaveText('That did not work.');
  await expect(page.getByText("The page's address")).toBeVisible();
  await expect(app.result).toBeHidden();
});
