// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { blindReaders } from './support/workers.js';

const kText = 'Grüße ☕';
const kPrinted = { timeout: 60_000 }; // time for the simulation of the print

test('The verdict of a good carving has three lines: reads, prints, solid', async ({ page }) => {
  const app = new Engraver(page);
  await app.open(`?sample=saddle&text=${encodeURIComponent(kText)}`);
  await app.expectReady();
  await expect(app.text).toHaveValue(kText);
  await app.engraveButton.focus();
  await page.keyboard.press('Enter');
  await app.expectResult();
  const lines = app.result.getByRole('list', { name: 'Verdict' }).getByRole('listitem');
  await expect(lines).toHaveCount(3);
  await expect(lines.nth(0)).toContainText(
    /Reads as Grüße ☕\s*\d+ of 72 tries on simulated phone pictures succeeded; 29 are needed\. \d+\s% of the error correction is left\./,
  );
  await expect(lines.nth(1)).toContainText(
    /Reads as printed, facing up \(0\.4\smm nozzle, 0\.2\smm layers\)\s*\d+ of 72 tries on simulated phone pictures of the printed surface succeeded; 12 are needed\./,
    kPrinted,
  );
  await expect(lines.nth(2)).toContainText(/Solid\s*Closed and manifold, [\d,]+ triangles\./);
  await expect(lines.getByRole('button')).toHaveCount(0);
  await expect(page.locator('#check-state')).toHaveText('Reads, prints, solid');
  await expect(page.getByRole('heading', { name: 'Check and download' })).toBeFocused();
  expect(await app.unexplained()).toEqual([]);

  await test.step('Grades and views behind the verdict appear on demand, marked as simulated', async () => {
    const table = page.getByRole('table', { name: 'As a direct part mark, ISO/IEC 29158' });
    await expect(table).toBeHidden();
    await page.getByText('Grades and views').click();
    await expect(table).toBeVisible();
    await expect(app.result).toContainText('All of this is simulated');
    const { verification } = await app.report();
    const letter = 'FDCBA'[verification.iso29158.overall];
    await expect(table.getByRole('row', { name: 'Overall' })).toContainText(letter);
    await expect(table.getByRole('row', { name: 'Cell contrast' })).toContainText(
      `${Math.round(verification.iso29158.cellContrast.value * 100)}\u00a0%`,
    );
    await expect(page.getByRole('table', { name: 'As a printed symbol, ISO/IEC 15415' }).getByRole('row')).toHaveCount(
      9,
    );

    await page.getByRole('button', { name: 'Try other views' }).click();
    await expect(app.result).toContainText(/Tilted by\s5°: 4 of 4 directions read/);
    const safe = Number(/Reads from every side up to\s(\d+)°/.exec(await app.result.innerText())?.[1]);
    expect([5, 10, 15, 30, 45]).toContain(safe);
    const advice = page.getByText('a smaller code or a flatter spot can be read from wider angles');
    await expect(advice).toHaveCount(safe < 10 ? 1 : 0);
    await expect(app.result).toContainText(/Reads up to about \d+\scm away, at [\d.]+ pixels per module/);
  });

  await test.step('Words and numbers follow the page’s language', async () => {
    await page.getByRole('combobox', { name: 'Language' }).selectOption('Deutsch');
    const tooWide = await page.locator('#panel').evaluate((panel) => panel.scrollWidth - panel.clientWidth);
    expect(tooWide).toBe(0);
    await expect(page.getByRole('region', { name: 'Ergebnis' })).toContainText(/Tiefe\s*\d+,\d\d\smm im Mittel/);
    await page.getByRole('combobox', { name: 'Sprache' }).selectOption('English');
    await expect(app.result).toContainText(/Depth\s*\d+\.\d\d\smm on average/);
  });

  await test.step('After a change the result is marked as outdated', async () => {
    await expect(app.result).not.toContainText('Made before your last change');
    await app.text.fill('another text');
    await expect(app.result).toContainText('Made before your last change. Engrave again to update it.');
  });
});

test('A carving too fine for the nozzle offers remedies, and a click on one sets the control and places the code again', async ({
  page,
}) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=fine');
  await app.expectReady();
  await app.openSettings();
  await app.setting('Modules').selectOption('Full');
  await app.setting('Engrave for').selectOption('Design only');
  await app.setting('Nozzle (mm)').fill('0.8');
  await app.setting('Nozzle (mm)').press('Tab');
  await app.setting('At most (mm)').fill('26'); // a limit that the user chose is not widened
  await app.setting('At most (mm)').press('Tab');
  await app.expectReady();
  await app.engrave();
  const verdict = app.result.getByRole('list', { name: 'Verdict' });
  await expect(verdict).toContainText(
    /(does not read|Barely reads) as printed, facing up \(0\.8\smm nozzle, 0\.2\smm layers\)/,
    kPrinted,
  );
  await expect(page.locator('#check-state')).toHaveText('Reads, but may not print');
  const before = await app.placement.innerText();
  await verdict.getByRole('button', { name: /^Allow \d+\smm$/ }).click();
  await expect(app.status).toHaveText(/^Allow (\d+)\smm: set “At most \(mm\)” to \1\.$/);
  expect(await app.placement.innerText()).not.toBe(before);
  await expect(app.result).toContainText('Made before your last change');

  await app.result.getByText('Why, and what else helps').click();
  await verdict.getByRole('button', { name: 'Use a 0.4 mm nozzle' }).click();
  await expect(app.setting('Nozzle (mm)')).toHaveValue('0.4');
  await app.engrave();
  await expect(verdict).toContainText(/Reads as printed, facing up \(0\.4\smm nozzle, 0\.2\smm layers\)/, kPrinted);
});

test('A code that does not decode is carved with the next deeper preset, and one undo reverts both', async ({
  page,
}) => {
  await page.addInitScript(blindReaders, 2); // carved for print and design, then for the design alone
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=deeper');
  await app.expectReady();
  await app.setting('How deep').selectOption('shallow');
  await app.engrave();
  await expect(app.status).toHaveText('Engraved deeper than you chose: at that depth the code did not read reliably.');
  await expect(app.setting('How deep')).toHaveValue('balanced');
  await expect(app.result).toContainText('Reads as deeper');
  expect((await app.report()).depth.preset).toBe('balanced');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(app.setting('How deep')).toHaveValue('shallow');
  await expect(app.result).toBeHidden();
});
