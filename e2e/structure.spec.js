// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';

const kSteps = ['Model', 'Code', 'Place', 'Engrave', 'Check and download'];

test('Headings, landmarks, the skip link and a live region lead through the five steps', async ({ page }) => {
  await page.addInitScript(() => {
    const announcements = /** @type {string[]} */ (/** @type {any} */ (window).told = []);
    new MutationObserver(() => {
      const status = document.querySelector('[role="status"]')?.textContent ?? '';
      if (status && announcements.at(-1) !== status) announcements.push(status);
    }).observe(document, { subtree: true, childList: true, characterData: true });
  });
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=live');
  await app.expectReady();

  await test.step('the live region reports progress in words', async () => {
    const announcements = await page.evaluate(() => /** @type {any} */ (window).told);
    expect(announcements[0]).toBe('Starting…');
    expect(announcements).toContain('Reading saddle.stl…');
    expect(announcements.at(-1)).toBe('Ready.');
  });
  await test.step('headings and landmarks are in order', async () => {
    await expect(page.getByRole('heading', { level: 1 })).toHaveText('QRelief');
    await expect(page.getByRole('form', { name: 'Steps' }).getByRole('heading', { level: 2 })).toHaveText(kSteps);
    for (const name of kSteps) await expect(page.getByRole('region', { name, exact: true })).toBeVisible();
    await expect(page.getByRole('main', { name: '3D model' })).toBeVisible();
    await expect(page.getByRole('navigation', { name: 'More' }).getByRole('link')).not.toHaveCount(0);
  });
  await test.step('the first Tab offers to skip the view', async () => {
    await page.keyboard.press('Tab');
    const skip = page.getByRole('link', { name: 'Skip to the steps' });
    await expect(skip).toBeFocused();
    await expect(skip).toBeInViewport();
    await page.keyboard.press('Enter');
    await page.keyboard.press('Tab');
    await expect(page.getByRole('form', { name: 'Steps' }).locator(':focus')).toHaveCount(1);
  });
});
