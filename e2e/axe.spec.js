// SPDX-License-Identifier: GPL-3.0-or-later
// What axe finds in each state of each page, light and dark: nothing.
import { AxeBuilder } from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { untilKept } from './support/kept.js';
import { truncatedFile } from './support/models.js';

/** @typedef {import('@playwright/test').Page} Page */

/** @param {Page} page @param {string} state */
async function expectNoViolations(page, state) {
  const { violations } = await new AxeBuilder({ page }).analyze();
  const found = violations.flatMap(({ id, help, nodes }) => nodes.map(({ html, failureSummary }) => `${id}: ${help}: ${html} ${failureSummary}`));
  expect.soft(found, state).toEqual([]);
}

for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
  test.describe(colorScheme, () => {
    test.use({ colorScheme });

    test('The app has no violations at the start, with settings open, after an error, with a result and with help', async ({ page }) => {
      const app = new Engraver(page);
      await app.open('?sample=plate&text=A');
      await app.expectReady();
      await expectNoViolations(page, 'start');
      await app.openSettings();
      await expectNoViolations(page, 'settings');
      await app.file.setInputFiles(truncatedFile);
      await expect(app.alert).toBeVisible();
      await expectNoViolations(page, 'error');
      await page.getByRole('button', { name: 'Dismiss' }).click();
      await app.engrave();
      await expectNoViolations(page, 'result');
      await page.keyboard.press('?');
      await expect(page.getByRole('dialog')).toBeVisible();
      await expectNoViolations(page, 'help');
    });

    test('The app has no violations with the last visit’s work on offer', async ({ page }) => {
      const app = new Engraver(page);
      await app.open();
      await app.expectReady();
      await app.sample.selectOption('Star');
      await expect(app.facts).toContainText('Star');
      await app.expectReady();
      await untilKept(page, (kept) => kept?.sampleId === 'star');
      await page.reload();
      await expect(page.getByRole('button', { name: 'Continue' })).toBeVisible();
      await app.expectReady();
      await expectNoViolations(page, 'offer');
    });

    test('The app has no violations with any form of content, with spots, and with what lies over the view', async ({ page }) => {
      const app = new Engraver(page);
      const press = (/** @type {string} */ name) => page.getByRole('button', { name, exact: true }).click();
      await app.open('?sample=plate&text=A');
      await app.expectReady();
      const kinds = page.getByRole('combobox', { name: 'Kind of content' });
      const names = await kinds.getByRole('option').allInnerTexts();
      expect(names.length).toBeGreaterThan(5);
      for (const name of names.slice(1)) {
        await kinds.selectOption(name);
        await expectNoViolations(page, name);
      }
      await app.engraveButton.click();
      await expect(page.locator('[aria-invalid="true"]')).not.toHaveCount(0);
      await expectNoViolations(page, 'missing');
      await kinds.selectOption(names[0]);
      await app.text.fill('A');
      await app.suggest();
      await expectNoViolations(page, 'spots');
      await press('Views');
      await expectNoViolations(page, 'views');
      await press('Section');
      await expectNoViolations(page, 'section');
      await app.engrave();
      await page.getByText('Grades and views').click();
      await press('Depths');
      await expectNoViolations(page, 'grades and depths');
      await press('Reader’s view');
      await expectNoViolations(page, 'reader’s view');
      await press('Inspector');
      await expectNoViolations(page, 'inspector');
      await app.text.fill('B');
      await expectNoViolations(page, 'older than the settings');
    });

    test('The guide and the method page have no violations', async ({ page }) => {
      await page.goto('./guide.html');
      await expectNoViolations(page, 'guide');
      await page.goto('./method.html');
      await expect(page.getByRole('status')).toHaveText(/^Done in/, { timeout: 170_000 });
      await expectNoViolations(page, 'method');
    });
  });
}
