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
  await test.step('every disabled button says why, in each language', async () => {
    expect(await app.unexplained()).toEqual([]);
    const carved = page.locator('#show-carved');
    await expect(carved).toHaveAttribute('title', 'First engrave.');
    await page.getByRole('combobox', { name: 'Language' }).selectOption('de');
    await expect(carved).toHaveAttribute('title', 'Erst gravieren.');
    await page.getByRole('combobox', { name: 'Sprache' }).selectOption('en');
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

test('Focus is never hidden under the Engrave bar, and states show in forced colours', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=plate&text=A');
  await app.expectReady();
  await app.openSettings();

  await test.step('each control that has the focus can be seen', async () => {
    const covered = await page.evaluate(() => {
      const bar = document.querySelector('.actions');
      const controls = document.querySelectorAll(
        ':is(#panel) :is(input, select, textarea, button, summary, a[href]):not(:disabled)',
      );
      /** @type {string[]} */ const hidden = [];
      let seen = 0;
      for (const control of /** @type {NodeListOf<HTMLElement>} */ (controls)) {
        if (!control.checkVisibility({ visibilityProperty: true }) || bar?.contains(control)) continue;
        control.focus();
        if (document.activeElement !== control) continue;
        seen += 1;
        const { bottom, height } = control.getBoundingClientRect();
        const top = bar?.getBoundingClientRect().top ?? 0;
        const isBelow = control.getBoundingClientRect().top >= (bar?.getBoundingClientRect().bottom ?? 0);
        if (!isBelow && bottom > top + 1 && height < top) hidden.push(control.id || control.outerHTML.slice(0, 80));
      }
      return { hidden, seen };
    });
    expect(covered.seen).toBeGreaterThan(30);
    expect(covered.hidden).toEqual([]);
  });

  await test.step('in forced colours the chosen one of two differs from the other', async () => {
    await page.emulateMedia({ forcedColors: 'active' });
    const colours = await page.evaluate(() =>
      ['.segments input:checked + span', '.segments input:not(:checked) + span'].map((selector) => {
        const choice = document.querySelector(selector);
        return choice && getComputedStyle(choice).backgroundColor;
      }),
    );
    expect(colours[0]).toBeTruthy();
    expect(colours[0]).not.toBe(colours[1]);
    await page.emulateMedia({ forcedColors: 'none' });
  });

  await test.step('at 400 % zoom, 320 by 256 pixels, everything can be reached by scrolling the page one way', async () => {
    await page.setViewportSize({ width: 320, height: 256 });
    expect(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth)).toBe(
      0,
    );
    await app.text.focus();
    await expect(app.text).toBeInViewport({ ratio: 0.9 });
    await app.engraveButton.focus();
    await expect(app.engraveButton).toBeInViewport({ ratio: 1 });
  });
});
