// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { shareOf } from './support/pixels.js';
import { poll } from './support/poll.js';
import { freeze, holdWorkers, thaw } from './support/workers.js';

test('A suggested spot fits a code of the promised size and is engraved', async ({ page }) => {
  const app = new Engraver(page);
  const aim = page.locator('#placement-aim');
  const degrees = async () => Number(/(\d+)°/.exec(await aim.innerText())?.[1]);
  await app.open();
  await app.expectReady();

  await test.step('a spot says how straight to hold the phone and what would tolerate more', async () => {
    await expect(aim).toHaveText(
      /must hold the phone straight: it reads the code from \d° to the side at most. A smaller code or a flatter spot forgives more/,
    );
    const before = await degrees();
    await app.openSettings();
    await app.setting('At most (mm)').fill('15');
    await app.setting('At most (mm)').press('Tab');
    await poll(degrees).toBeGreaterThan(before + 2);
    await app.expectReady();
    await page.getByRole('button', { name: 'Undo' }).click();
    await poll(degrees).toBe(before);
    await expect(page.getByRole('button', { name: 'Redo' })).toBeEnabled();
  });

  const proposed = await app.centre();
  await app.suggest();
  await expect(page.getByRole('button', { name: 'Sizes' })).toHaveAttribute('aria-pressed', 'true');
  await expect(page.getByLabel('Colours of the model')).toContainText(
    /Largest code that fits, prints and reads from aside\s*0\smm\s*[\d.]+\smm\s*[\d.]+\smm/,
  );

  expect(await app.spots.count()).toBeGreaterThanOrEqual(3);
  await expect(app.spots.locator('canvas.drawn')).toHaveCount(await app.spots.count());
  const isDark = (/** @type {number} */ red, /** @type {number} */ green, /** @type {number} */ blue) =>
    Math.max(red, green, blue) < 115; // nothing but modules is as dark
  expect(await shareOf(app.spots.first().locator('canvas'), isDark)).toBeGreaterThan(0.01);
  const spot = app.spots.nth(1);
  const [, room, aside] = (/room for about ([\d.]+)\smm, (\d+)°/.exec(await spot.innerText()) ?? []).map(Number);
  await spot.click();
  await expect(spot).toHaveAttribute('aria-pressed', 'true');
  await poll(() => app.centre()).not.toEqual(proposed);
  await app.expectReady();
  const width = Number(/^([\d.]+)\smm wide/.exec(await app.placement.innerText())?.[1]);
  expect(Math.abs(width - room)).toBeLessThanOrEqual(0.6); // rounded to 1 mm
  expect(Math.abs((await degrees()) - aside)).toBeLessThanOrEqual(1);

  await app.engrave();
  await expect(app.result).toContainText('Reads as');
  await expect(page.getByLabel('Colours of the model')).toBeHidden();
});

test('A spot search waits for the typed text; a change of settings discards the spots', async ({ page }) => {
  await page.addInitScript(holdWorkers);
  const app = new Engraver(page);
  await app.open('?sample=plate&text=A');
  await app.expectReady();
  await expect(page.locator('#placement-aim')).toHaveText('Here a phone can read it from up to 45° to the side.');
  const typed = 'Another text, for which a larger symbol is needed than for the one before';
  await app.text.fill(typed);
  await app.suggest();
  await expect(app.spots).not.toHaveCount(0);
  await expect(page.locator('#symbol-facts')).toContainText('37 × 37 modules');

  const sizes = page.getByRole('button', { name: 'Sizes' });
  const legend = page.getByLabel('Colours of the model');
  await test.step('the sizes can be hidden and shown again', async () => {
    await sizes.click();
    await expect(legend).toBeHidden();
    await sizes.click();
    await expect(legend).toBeVisible();
  });
  await test.step('As carved leaves the status as it is', async () => {
    await app.showLive();
    await expect(app.status).toHaveText('Choose a spot, or click the model.');
  });
  await test.step('Ctrl+Z right after a choice undoes the choice alone', async () => {
    const before = await app.centre();
    await freeze(page);
    await app.spots.nth(1).click();
    await page.keyboard.press('Control+z');
    await thaw(page);
    await expect(page.getByRole('button', { name: 'Redo' })).toBeEnabled();
    await poll(() => app.centre()).toEqual(before);
    await expect(app.text).toHaveValue(typed);
    await expect(app.spots.nth(1)).toHaveAttribute('aria-pressed', 'false');
  });
  await test.step('a change of settings discards them', async () => {
    await app.openSettings();
    await app.setting('Minimum wall (mm)').fill('1');
    await app.setting('Minimum wall (mm)').press('Tab');
    await expect(app.spots).toHaveCount(0);
    await expect(sizes).toBeHidden();
    await expect(legend).toBeHidden();
  });
  await test.step('if every spot has a concern, that is reported before carving', async () => {
    const note = page.getByText('At none of these spots is the print sure to be readable.');
    await expect(note).toBeHidden();
    await app.setting('Size of the code').selectOption('Exactly');
    await app.setting('Width (mm)').fill('25');
    await app.setting('Process').selectOption('fdm-0.6/0.3');
    await app.suggest();
    await expect(app.spots.first()).toContainText('The code is too small for a nozzle of 0.6 mm');
    await expect(note).toBeVisible();
    await app.setting('Process').selectOption('fdm-0.4/0.2');
    await expect(note).toBeHidden();
  });
  await test.step('and it is reported if there is no spot', async () => {
    await app.setting('Width (mm)').fill('300');
    await app.setting('Width (mm)').press('Tab');
    await expect(app.alert).toContainText('300 mm');
    await page.getByRole('button', { name: 'Suggest spots' }).click();
    await expect(app.alert).toContainText('No spot on the model has room for a code of 300 mm');
    await expect(app.alert).toContainText('the largest size found is');
  });
});

test('Lamps that light the spot unevenly are named once, beside the lamps, before the carving', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=bumpy-sphere&light=0,20,4%20180,20,4');
  await app.expectReady();
  const lights = (/** @type {string} */ words) => page.getByText(`${words} this spot unevenly; decoders may fail.`);
  const notes = page.getByRole('list', { name: 'Notes on the light' });
  await expect(notes).toContainText('The lamps light this spot unevenly; decoders may fail. Choose a flatter spot');
  await expect(lights('The lamps light')).toHaveCount(1);
  await app.setting('The code is seen in').selectOption('Light of one lamp');
  await expect(notes).toContainText('The lamp lights this spot unevenly; decoders may fail.');
  await expect(lights('The lamp lights')).toHaveCount(1);
  await app.setting('The code is seen in').selectOption('Even light');
  await expect(notes).toBeEmpty();
});

test('With a fixed size, the map shows where it fits', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle&size=20');
  await app.expectReady();
  await app.suggest();
  const legend = page.getByLabel('Colours of the model');
  await expect(legend).toContainText(/Room for a code of\s20\smm, turned as you like\s*no\s*yes/);
  const isNear =
    (/** @type {number[]} */ colour) =>
    (/** @type {number} */ red, /** @type {number} */ green, /** @type {number} */ blue) =>
      Math.hypot(red - colour[0], green - colour[1], blue - colour[2]) < 60;
  await poll(() => shareOf(app.canvas, isNear([253, 231, 37]))).toBeGreaterThan(0.01);
  expect(await shareOf(app.canvas, isNear([68, 1, 84]))).toBeGreaterThan(0.01);
});
