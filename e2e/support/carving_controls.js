// SPDX-License-Identifier: GPL-3.0-or-later
// Effects of the controls of the carving and its result, for controls.spec.js.
import { expect } from '@playwright/test';
import { hold, showOverlays } from './hands.js';
import { Inspector } from './inspector.js';
import { isOrange, isTeal, shareOf } from './pixels.js';
import { poll } from './poll.js';
import { unzip } from './three_mf.js';
import { freeze, thaw } from './workers.js';

/** @type {import('./hands.js').Effects} */
export const kOfTheCarving = {
  fit: async ({ app, page, press }) => {
    const place = async () => (await app.moveHandle.boundingBox())?.x;
    const before = await place();
    await app.canvas.focus();
    for (let i = 0; i < 4; i += 1) await page.keyboard.press('Shift+ArrowRight');
    await poll(place).not.toBe(before);
    await press('fit');
    await poll(place).toBe(before);
  },
  'show-section': async ({ at, press }) => {
    await press('show-section');
    await expect(at('section-position')).toBeVisible();
  },
  'section-position': async ({ app, at, press }) => {
    await poll(() => shareOf(app.canvas, isOrange)).toBeGreaterThan(0.005);
    const before = await shareOf(app.canvas, isOrange);
    await at('section-position').fill('0.9');
    await poll(async () => Math.abs((await shareOf(app.canvas, isOrange)) / before - 1)).toBeGreaterThan(0.05);
    await press('show-section');
    await expect(at('section-position')).toBeHidden();
  },
  engrave: async ({ app, press }) => {
    await press('engrave');
    await app.expectResult();
  },
  'show-carved': async ({ app, at, press }) => {
    await expect(at('show-carved')).toHaveAttribute('aria-pressed', 'true');
    await press('show-carved');
    await expect(app.moveHandle).toBeVisible();
    await press('show-carved');
    await expect(app.moveHandle).toBeHidden();
  },
  'show-depths': async ({ page, press }) => {
    await press('show-depths');
    await expect(page.getByLabel('Colours of the model')).toContainText('Depth of the engraving');
  },
  'show-before': async ({ app, at, page }) => {
    await showOverlays(page, false); // they use the colours of depths, too
    await poll(() => shareOf(app.canvas, isTeal)).toBeGreaterThan(0.0013);
    await hold(at('show-before'), async () => {
      await expect(at('show-before')).toHaveAttribute('aria-pressed', 'true');
      await poll(() => shareOf(app.canvas, isTeal)).toBeLessThan(0.001);
    });
    await poll(() => shareOf(app.canvas, isTeal)).toBeGreaterThan(0.0013);
    await showOverlays(page, true);
  },
  'reader-view': async ({ page, press }) => {
    await press('reader-view');
    await expect(page.getByRole('group', { name: 'Phone view' })).toContainText('The phone reads');
  },
  inspector: async ({ page, press }) => {
    await press('inspector');
    await poll(() => new Inspector(page).state()).toBeDefined();
    await press('inspector');
    await poll(() => new Inspector(page).state()).toBeUndefined();
  },
  slicer: async ({ app, at }) => {
    await expect(at('slicer')).toBeHidden();
    await at('format').selectOption('3MF, two colours');
    await at('slicer').selectOption('PrusaSlicer');
    const { name, bytes } = await app.download();
    expect(name).toMatch(/-inlay\.3mf$/);
    const files = [...unzip(bytes).keys()];
    expect(files).toContain('Metadata/Slic3r_PE_model.config');
    expect(files).not.toContain('Metadata/model_settings.config');
  },
  format: async ({ app, at }) => {
    await at('format').selectOption('PLY');
    expect((await app.download()).name).toMatch(/\.ply$/);
  },
  download: async ({ at, page, press }) => {
    const format = await at('format').inputValue();
    const [download] = await Promise.all([page.waitForEvent('download'), press('download')]);
    expect(download.suggestedFilename()).toMatch(new RegExp(`\\.${format}$`));
  },
  'save-report': async ({ page, press }) => {
    const [download] = await Promise.all([page.waitForEvent('download'), press('save-report')]);
    expect(download.suggestedFilename()).toMatch(/\.json$/);
  },
  'save-maps': async ({ page, press }) => {
    const [download] = await Promise.all([page.waitForEvent('download'), press('save-maps')]);
    expect(download.suggestedFilename()).toMatch(/-maps\.npz$/);
  },
  'download-previous': async ({ app, at, page, press }) => {
    const [download] = await Promise.all([page.waitForEvent('download'), press('download')]);
    await at('text').fill('carved anew');
    await app.expectReady();
    const [previous] = await Promise.all([page.waitForEvent('download'), press('download-previous')]);
    expect(previous.suggestedFilename()).toBe(download.suggestedFilename());
  },
  'engrave-again': (hands) => cancelAfter('engrave-again', hands),
  cancel: (hands) => cancelAfter('engrave', hands),
  'another-code': async ({ app, press }) => {
    await press('another-code');
    await expect(app.facts).toContainText('.3mf');
    await expect(app.result).toBeHidden();
  },
};

/** Presses a button that engraves, and cancels it. @param {string} id @param {import('./hands.js').Hands} hands */
async function cancelAfter(id, { app, page, press }) {
  await freeze(page); // otherwise the work may end before it is cancelled
  await press(id);
  await press('cancel');
  await expect(app.cancelButton).toBeHidden();
  await expect(app.status).toHaveText('Cancelled. The model is unchanged.');
  await thaw(page);
  await app.expectReady();
}
