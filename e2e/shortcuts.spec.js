// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';

test('Shortcuts work from text to download, but not while typing or under the help sheet, and can be switched off', async ({
  page,
}) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=start&process=none');
  await app.expectReady();

  await test.step('a question mark opens the help sheet, Escape closes it, and the focus returns', async () => {
    await app.canvas.focus();
    await page.keyboard.press('?');
    const sheet = page.getByRole('dialog', { name: 'Keys, mouse and fingers' });
    await expect(sheet).toBeVisible();
    await expect(sheet).toContainText('Ctrl Shift ZRedo');
    await page.keyboard.press('e'); // no shortcut works under the dialog
    await expect(app.progress).toBeHidden();
    await expect(app.status).toHaveText('Ready.');
    await page.keyboard.press('Escape');
    await expect(sheet).toBeHidden();
    await expect(app.canvas).toBeFocused();
    await page.getByRole('button', { name: 'Help' }).click();
    await expect(sheet).toBeVisible();
    await sheet.getByRole('button', { name: 'Close' }).click();
    await expect(sheet).toBeHidden();
  });

  await test.step('while typing', async () => {
    await app.canvas.focus();
    await page.keyboard.press('t');
    await expect(app.text).toBeFocused();
    await page.keyboard.press('End');
    await page.keyboard.type(' edse?');
    await expect(app.text).toHaveValue('start edse?');
    await expect(page.getByRole('dialog')).toHaveCount(0);
    await app.expectReady();
    await expect(app.progress).toBeHidden();
    await expect(app.result).toBeHidden();
  });

  await test.step('undo, redo, engrave, download', async () => {
    await app.canvas.focus();
    await page.keyboard.press('Control+z');
    await expect(app.text).toHaveValue('start');
    await expect(page.getByRole('button', { name: 'Redo' })).toBeEnabled();
    await page.keyboard.press('Control+Shift+Z');
    await expect(app.text).toHaveValue('start edse?');
    await expect(page.getByRole('button', { name: 'Undo' })).toBeEnabled();
    await app.expectReady();
    await page.keyboard.press('e');
    await app.expectResult();
    const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('d')]);
    expect(download.suggestedFilename()).toMatch(/\.stl$/);
  });

  await test.step('switched off, also after a reload', async () => {
    await page.getByRole('button', { name: 'Help' }).click();
    await page.getByRole('checkbox', { name: /Single keys/ }).uncheck();
    await page.keyboard.press('Escape');
    await page.reload();
    await app.expectReady();
    await page.keyboard.press('t');
    await expect(app.text).not.toBeFocused();
    await page.getByRole('button', { name: 'Help' }).click();
    await expect(page.getByRole('checkbox', { name: /Single keys/ })).not.toBeChecked();
  });
});
