// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { Inspector } from './support/inspector.js';
import { countOf } from './support/pixels.js';
import { poll } from './support/poll.js';
import { readPng } from './support/read_png.js';

/** @typedef {import('../web/engine/types.js').InspectorState} State */
/** @typedef {NonNullable<State['selected']>} Selected */
/** @typedef {{ x: number, y: number, width: number, height: number }} Clip */

// In a smaller view the inspector covers what the tests click.
test.use({ viewport: { width: 1280, height: 800 } });

const kBalancedContrast = 0.3;

/** Far from grey: belongs to a map and not to the model. @type {import('./support/pixels.js').Colour} */
const isColourful = (red, green, blue) => Math.max(red, green, blue) - Math.min(red, green, blue) > 60;

/** Presses the dark middle of the upper left finder pattern. @param {Inspector} inspector */
async function pressDark(inspector) {
  await inspector.press('Map', { x: 7.5 / 37, y: 7.5 / 37 }); // 29 modules and a margin of 4 on each side
  await poll(async () => (await inspector.state())?.selected?.role).toBe('finder');
  return /** @type {Selected} */ ((await inspector.state())?.selected);
}

/** c in G = AL·(c − 1) + LS. @param {Selected} submodule */
const contrastOf = ({ LS, AL, G }) => 1 - (LS - Number(G)) / Number(AL);

test('The inspector covers only the view, shows an engraving, and closes without a trace', async ({ page }) => {
  const app = new Engraver(page);
  const inspector = new Inspector(page);
  await app.open(`?sample=bumpy-sphere&contrast=${kBalancedContrast}&process=none`); // for finder patterns, too
  await app.expectReady();
  await inspector.open();

  await test.step('no button over the view is covered', async () => {
    const { window, passes } = /** @type {State} */ (await inspector.state());
    expect(passes).toBe(0);
    const canvas = /** @type {Clip} */ (await app.canvas.boundingBox());
    for (const button of await page.getByRole('toolbar', { name: 'View' }).getByRole('button').all()) {
      const box = /** @type {Clip} */ (await button.boundingBox());
      const [x, y, width, height] = [canvas.x + window[0], canvas.y + window[1], window[2], window[3]];
      expect(box.x >= x + width || box.x + box.width <= x || box.y >= y + height || box.y + box.height <= y).toBe(true);
    }
  });

  await test.step('a click beside it still places the code', async () => {
    const before = await app.centre();
    const box = /** @type {Clip} */ (await app.canvas.boundingBox());
    await page.mouse.click(box.x + box.width * 0.6, box.y + box.height * 0.4);
    await poll(() => app.centre()).not.toEqual(before);
    await app.expectReady();
  });

  await app.engrave();
  await inspector.expectState((state) => state.passes > 1 && state.pass === state.passes, true);
  const clip = await inspector.clipOf('Map');
  await test.step('an engraving is shown', async () => {
    await poll(async () => countOf(readPng(await inspector.picture(clip)), isColourful)).toBeGreaterThan(5000);
  });

  await test.step('a click on a submodule in the map shows its quantities', async () => {
    await inspector.press('Map', { x: 0.2, y: 0.8 });
    await inspector.expectState((state) => Boolean(state.selected), true);
    const inMap = /** @type {Selected} */ ((await inspector.state())?.selected);
    expect(inMap.row).toBeGreaterThan(inMap.column);
    const dark = await pressDark(inspector);
    expect(contrastOf(dark)).toBeCloseTo(kBalancedContrast, 4);
    expect(dark.G).toBeLessThanOrEqual(1e-4);
    expect(dark.depthMm).toBeGreaterThan(0);
    expect(dark.limitMm).toBeGreaterThanOrEqual(/** @type {number} */ (dark.depthMm));
    await page.getByText('What it shows, as text').click();
    const figures = page.getByRole('region', { name: 'What it shows, as text' });
    const depth = `depth ${dark.depthMm?.toFixed(4)} mm`;
    await expect(figures.getByRole('row', { name: depth, exact: true })).toBeVisible();
    await expect(figures).toContainText(`Submodule row ${dark.row}, column ${dark.column}: finder, carved`);
  });

  await test.step('every pass shows its own depths', async () => {
    const { passes } = /** @type {State} */ (await inspector.state());
    const last = await inspector.picture(clip);
    await inspector.press('Earlier pass');
    await inspector.expectState((state) => state.pass, passes - 1);
    await inspector.press('Pass', { x: 0.03, y: 0.5 });
    await inspector.expectState((state) => state.pass, 1);
    await poll(async () => (await inspector.picture(clip)).equals(last)).toBe(false);
    await inspector.openTab('Search');
    await inspector.openTab('Timing');
    await expect(page.getByRole('region', { name: 'What it shows, as text' })).toContainText(/depthSearch[\d.]+ ms/);
  });

  await test.step('a click on the model does the same', async () => {
    const before = await app.centre();
    await page.getByRole('button', { name: 'Phone view' }).click();
    const box = /** @type {Clip} */ (await app.canvas.boundingBox());
    const [x, y] = [box.x + box.width / 2 + 60, box.y + box.height / 2];
    await inspector.expectStill({ x: x - 50, y: y - 50, width: 100, height: 100 });
    await page.mouse.click(x, y);
    // The phone view shows the middle of the 145 submodules there. The click is a little to its right.
    await inspector.expectState(
      ({ selected }) => selected && [Math.abs(selected.row - 72) < 8, selected.column > 76],
      [true, true],
    );
    expect(await app.centre()).toEqual(before); // the inspector took the click
  });

  await test.step('closed, it leaves no trace', async () => {
    await inspector.openTab('Maps');
    await poll(async () => countOf(readPng(await inspector.picture(clip)), isColourful)).toBeGreaterThan(5000);
    await inspector.button.click();
    await poll(() => inspector.state()).toBeUndefined();
    await poll(async () => countOf(readPng(await inspector.picture(clip)), isColourful)).toBe(0);
  });
});

test('The inspector’s settings apply only to its own Engrave, can be typed, stepped and reset, in the page’s language', async ({
  page,
}) => {
  const app = new Engraver(page);
  const inspector = new Inspector(page);
  await app.open('?sample=bumpy-sphere&lang=de&process=none');
  await expect(app.status).toHaveText('Bereit.');
  await app.openSettings();
  await page.getByRole('button', { name: 'Inspektor' }).click();
  await inspector.openTab('Settings');
  await inspector.press('contrast', { x: 0.97, y: 0.5 }); // the field's plus button
  await inspector.expectState((state) => state.overrides, 'Kontrast 0.31');

  await test.step('its language follows the page’s', async () => {
    const clip = await inspector.clipOf('Engrave again');
    const german = await inspector.picture(clip);
    await page.getByRole('combobox', { name: 'Sprache' }).selectOption('en');
    await inspector.expectState((state) => state.overrides, 'Contrast 0.31');
    await poll(async () => (await inspector.picture(clip)).equals(german)).toBe(false);
  });

  await test.step('typed', async () => {
    await inspector.press('contrast', { x: 0.2, y: 0.5 });
    await inspector.expectState((state) => state.keyboard, true);
    await page.keyboard.press('Control+A');
    await page.keyboard.type('0.25');
    await page.keyboard.press('Enter');
    await inspector.expectState((state) => state.overrides, 'Contrast 0.25');
    await expect(app.setting('Contrast')).toHaveValue('');
  });

  await test.step('for its own Engrave', async () => {
    await inspector.press('Engrave again');
    await expect(app.status).toContainText('Contrast 0.25', { timeout: 240_000 });
    await inspector.openTab('Maps');
    await poll(async () => contrastOf(await pressDark(inspector))).toBeCloseTo(0.25, 4);
  });

  await test.step('stepped and reset', async () => {
    await inspector.openTab('Settings');
    await inspector.press('contrast', { x: 0.97, y: 0.5 });
    await inspector.expectState((state) => state.overrides, 'Contrast 0.26');
    await inspector.press('Reset all');
    await inspector.expectState((state) => state.overridden, 0);
  });

  await test.step('not for the page’s', async () => {
    await inspector.openTab('Maps');
    await app.engrave();
    await poll(async () => contrastOf(await pressDark(inspector))).toBeCloseTo(kBalancedContrast, 4);
  });
});
