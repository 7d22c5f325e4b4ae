// SPDX-License-Identifier: GPL-3.0-or-later
// Effects of the controls of the page as a whole and of the buttons that turn the view; see controls.spec.js.
import { expect } from '@playwright/test';
import { showOverlays } from './hands.js';
import { poll } from './poll.js';

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {import('./hands.js').Hands} Hands */
/** @typedef {import('./hands.js').Effects} Effects */

/** Returns the visible sides of the cube. @param {Page} page */
const sidesOf = (page) =>
  page.locator('.view-cube [data-view]').evaluateAll((all) => all.map((face) => face.getAttribute('data-view')).sort());

/** @type {Effects} */
export const kOfTheView = {
  ...Object.fromEntries(
    ['front', 'back', 'left', 'right', 'top', 'bottom'].map((side) => [
      side,
      async (/** @type {Hands} */ { page, press }) => {
        await press('views');
        await press(side);
        await poll(() => sidesOf(page)).toEqual([side]);
      },
    ]),
  ),
  iso: async ({ page, press }) => {
    await press('views');
    await press('iso');
    await poll(async () => (await sidesOf(page)).length).toBe(3);
  },
  'show-live': async ({ page, press }) => {
    const depth = page.locator('#placement-depth');
    await press('show-live');
    await expect(depth).toBeHidden();
    await press('show-live'); // shows it at least once, however slow the machine is
    await expect(depth).toBeVisible();
  },
  'show-plate': async ({ page, press }) => {
    const height = page.getByText(/^[\d.]+\smm high$/);
    await press('views');
    await press('iso');
    await expect(height).toBeVisible();
    await press('show-plate');
    await expect(height).toBeHidden();
    await press('show-plate');
    await expect(height).toBeVisible();
  },
  'show-lamp-light': async ({ app, at, page, press }) => {
    await expect(at('show-lamp-light')).toBeHidden(); // no lamps
    await at('lamp-count').selectOption('1');
    await app.expectReady();
    await at('lamp-1-strength').fill('9');
    await at('lamp-1-strength').press('Tab');
    await app.expectReady();
    await showOverlays(page, false);
    const lit = await app.settledPicture();
    await press('show-lamp-light');
    await poll(() => app.differenceFrom(lit)).toBeGreaterThan(0.004);
    await showOverlays(page, true);
    await at('lamp-count').selectOption('0');
    await expect(at('show-lamp-light')).toBeHidden();
    await app.expectReady();
  },
  'show-construction': async ({ page, press }) => {
    const legend = page.locator('.construction-legend');
    await press('show-construction');
    await expect(legend).toContainText(/S, its point closest to C: [\d.]+\smm/);
    await press('show-construction');
    await expect(legend).toBeHidden();
  },
  views: async ({ at, press }) => {
    await press('views');
    await expect(at('views-menu')).toBeVisible();
    await press('views');
    await expect(at('views-menu')).toBeHidden();
  },
};

/** @type {Effects} */
export const kOfThePage = {
  help: async ({ at, press }) => {
    await press('help');
    await expect(at('help-sheet')).toBeVisible();
  },
  'single-keys': async ({ at, page, press }) => {
    await press('single-keys');
    await press('help-close');
    await page.keyboard.press('?');
    await expect(at('help-sheet')).toBeHidden();
    await press('help');
    await press('single-keys');
    await press('help-close');
    await page.keyboard.press('?');
    await expect(at('help-sheet')).toBeVisible();
  },
  'help-close': async ({ at, press }) => {
    await press('help-close');
    await expect(at('help-sheet')).toBeHidden();
  },
  theme: async ({ at }) => {
    const ground = () => at('panel').evaluate((panel) => getComputedStyle(panel).backgroundColor);
    const before = await ground();
    await at('theme').selectOption('dark');
    await poll(ground).not.toBe(before);
  },
  language: async ({ at, page }) => {
    await at('language').selectOption('de');
    await expect(page.getByRole('button', { name: 'Gravieren' })).toBeEnabled();
  },
};
