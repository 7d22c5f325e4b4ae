// SPDX-License-Identifier: GPL-3.0-or-later
// A pattern of one's own: drawn in its grid, shown before carving, saved and engraved.
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { settingsFile } from './support/hands.js';

/** @typedef {import('@playwright/test').Page} Page */

const kThickPlus = '01110/11111/11111/11111/01110';

/** @param {Page} page */
const gridOf = (page) => page.getByRole('group', { name: 'Own pattern' });

/** Returns the mask that the grid shows. @param {Page} page */
async function shownMask(page) {
  const cells = await gridOf(page).getByRole('button').all();
  const carved = await Promise.all(cells.map((cell) => cell.getAttribute('aria-pressed')));
  const digits = carved.map((pressed) => (pressed === 'true' ? '1' : '0')).join('');
  return digits.match(/.{5}/g)?.join('/');
}

test('A pattern of one’s own is drawn with clicks or keys, saved and engraved', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=plate');
  await app.expectReady();
  await app.openSettings();
  await expect(gridOf(page)).toBeHidden();
  await app.setting('Modules').selectOption('Own pattern');
  await expect(gridOf(page)).toBeVisible();
  expect(await shownMask(page)).toBe(kThickPlus);

  await test.step('A click changes a submodule', async () => {
    const cell = gridOf(page).getByRole('button', { name: 'Row 1, column 1' });
    await expect(cell).toHaveAttribute('aria-pressed', 'false');
    await cell.click();
    await expect(cell).toHaveAttribute('aria-pressed', 'true');
    expect((await settingsFile(app)).settings.patternMask).toBe('11110/11111/11111/11111/01110');
  });
  await test.step('Arrow keys lead to a submodule, and the space bar changes it', async () => {
    await gridOf(page).getByRole('button', { name: 'Row 1, column 1' }).focus();
    for (const key of ['ArrowUp', 'ArrowDown', 'ArrowDown', 'ArrowRight', 'ArrowRight']) await page.keyboard.press(key);
    await expect(gridOf(page).getByRole('button', { name: 'Row 3, column 3' })).toBeFocused();
    await page.keyboard.press('Space');
    expect(await shownMask(page)).toBe('11110/11111/11011/11111/01110');
    await page.keyboard.press('Shift+Tab'); // the grid is one stop
    await expect(app.setting('Modules')).toBeFocused();
  });
  await test.step('It is engraved', async () => {
    await app.expectReady();
    await app.engrave();
    expect((await app.report()).depth.patternMask).toBe('11110/11111/11011/11111/01110');
  });
  await test.step('Another pattern takes its place, and undo brings it back', async () => {
    await app.setting('Modules').selectOption('Square');
    await expect(gridOf(page)).toBeHidden();
    expect((await settingsFile(app)).settings).toMatchObject({ pattern: 'square' });
    expect((await settingsFile(app)).settings).not.toHaveProperty('patternMask');
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect(gridOf(page)).toBeVisible();
    expect(await shownMask(page)).toBe('11110/11111/11011/11111/01110');
  });
});

test('A pattern that engraves nothing is refused in words', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=plate&patternMask=00000/00000/00100/00000/00000');
  await app.expectReady();
  await app.openSettings();
  await expect(app.setting('Modules')).toHaveValue('own');
  await gridOf(page).getByRole('button', { name: 'Row 3, column 3' }).click();
  await expect(app.alert).toContainText('“Own pattern” is "00000/00000/00000/00000/00000", which is not a pattern');
  await gridOf(page).getByRole('button', { name: 'Row 1, column 5' }).click();
  await expect(app.alert).toBeHidden();
  await app.expectReady();
});
