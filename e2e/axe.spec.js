// SPDX-License-Identifier: GPL-3.0-or-later
// Axe finds no violations in any state of the app, light or dark. articles.spec.js checks the other pages.
import { expect, test } from '@playwright/test';
import { expectNoViolations } from './support/axe.js';
import { Engraver } from './support/engraver.js';
import { untilKept } from './support/kept.js';
import { truncatedFile } from './support/models.js';

test.use({ deviceScaleFactor: 1 }); // on a phone, too: no test here looks at the screen’s pixels

test('The app has no violations in any state, light or dark', async ({ page }) => {
  const app = new Engraver(page);
  const press = (/** @type {string} */ name) => page.getByRole('button', { name, exact: true }).click();
  const kinds = page.getByRole('combobox', { name: 'Kind of content' });
  const isPhone = test.info().project.name === 'phone';

  await test.step('with the work of the last visit on offer', async () => {
    await app.open();
    await app.expectReady();
    await app.sample.selectOption('Star');
    await expect(app.facts).toContainText('Star');
    await untilKept(page, (work) => work?.sampleId === 'star');
    await page.reload();
    await expect(page.getByRole('button', { name: 'Continue' })).toBeVisible();
    await app.expectReady();
    await expectNoViolations(page, 'offer');
  });

  await test.step('at the start, with settings open, after an error, with help', async () => {
    await app.open('?sample=plate&text=A');
    await app.expectReady();
    await expectNoViolations(page, 'start');
    await app.openSettings();
    await expectNoViolations(page, 'settings');
    await app.file.setInputFiles(truncatedFile);
    await expect(app.alert).toBeVisible();
    await expectNoViolations(page, 'error');
    await press('Dismiss');
    await page.keyboard.press('?');
    await expect(page.getByRole('dialog')).toBeVisible();
    await expectNoViolations(page, 'help');
    await page.keyboard.press('Escape');
  });

  // forms look the same on a phone
  if (!isPhone)
    await test.step('with any form of content', async () => {
      const names = await kinds.getByRole('option').allInnerTexts();
      expect(names.length).toBeGreaterThan(5);
      for (const name of names.slice(1)) {
        await kinds.selectOption(name);
        await expectNoViolations(page, name);
      }
      await kinds.selectOption('Wi-Fi access');
      await app.engraveButton.click();
      await expect(page.locator('[aria-invalid="true"]')).not.toHaveCount(0);
      await expectNoViolations(page, 'missing');
      await kinds.selectOption(names[0]);
      await app.text.fill('A');
    });

  await test.step('with spots and the overlays of the view', async () => {
    await app.suggest();
    await expectNoViolations(page, 'spots');
    await press('Views');
    await expectNoViolations(page, 'views');
    await press('Views'); // its menu lies above other buttons
    await press('Section');
    await expectNoViolations(page, 'section');
  });

  await test.step('with a result', async () => {
    await app.engrave();
    await expectNoViolations(page, 'result');
    await page.getByText('Grades and views').click();
    await press('Depths');
    await expectNoViolations(page, 'grades and depths');
    await press('Phone view');
    await expectNoViolations(page, 'phone view');
    await app.openSettings();
    await press('Inspector');
    await expectNoViolations(page, 'inspector');
    await app.text.fill('B');
    await expectNoViolations(page, 'older than the settings');
  });

  if (!isPhone)
    await test.step('with a code in a second colour', async () => {
      await press('Inspector');
      await app.setting('Made by').selectOption('Second colour, painted');
      await app.expectReady();
      await app.engrave();
      await app.openSettings();
      await expectNoViolations(page, 'painted');
    });
});
