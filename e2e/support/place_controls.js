// SPDX-License-Identifier: GPL-3.0-or-later
// Effects of the controls of the code and its place, for controls.spec.js.
import { expect } from '@playwright/test';
import { settingsFile, showOverlays } from './hands.js';
import { isDark, shareOf } from './pixels.js';
import { poll } from './poll.js';

/** @typedef {import('./engraver.js').Engraver} Engraver */

/**
 * Types a coordinate away from the surface. Once placed, the code is at the nearest point of the surface, with other
 * coordinates.
 * @param {Engraver} app
 * @param {import('@playwright/test').Locator} field
 * @param {string} value
 * @param {() => Promise<void>} confirm
 */
async function placeAt(app, field, value, confirm) {
  await field.fill(value);
  const typed = await app.centre();
  await confirm();
  await poll(() => app.centre()).not.toEqual(typed);
  await app.expectReady();
}

/**
 * Chooses a value and restores the old one, since some choices exclude others.
 * @param {Engraver} app
 * @param {import('@playwright/test').Locator} field
 * @param {string} setting
 * @param {string} value
 */
async function chooseAndBack(app, field, setting, value) {
  const before = await field.inputValue();
  await field.selectOption(value);
  await app.expectReady();
  expect((await settingsFile(app)).settings[setting]).toBe(value);
  await field.selectOption(before);
  await app.expectReady();
}

/** @type {import('./hands.js').Effects} */
export const kOfThePlace = {
  'lamp-count': async ({ app, at, page }) => {
    await at('lamp-count').selectOption('Light of one lamp');
    await app.expectReady();
    await expect(page.locator('.lamp-marks .sun')).toHaveCount(1);
  },
  'lamp-1-azimuthDeg': async ({ app, at }) => {
    await at('lamp-1-azimuthDeg').fill('');
    await at('lamp-1-azimuthDeg').press('Tab');
    await expect(app.alert).toContainText('“Lamp” is “?,40,1”, which is not a lamp. Give AZIMUTH,ELEVATION,STRENGTH');
    await at('lamp-1-azimuthDeg').fill('180');
    await at('lamp-1-azimuthDeg').press('Tab');
    await app.expectReady();
    await expect(app.alert).toBeHidden();
  },
  'lamp-1-elevationDeg': async ({ app, at }) => {
    await at('lamp-1-elevationDeg').fill('30');
    await at('lamp-1-elevationDeg').press('Tab');
    await app.expectReady();
  },
  'lamp-2-azimuthDeg': async ({ app, at, page }) => {
    await at('lamp-count').selectOption('Light of two lamps');
    await at('lamp-2-azimuthDeg').fill('270');
    await at('lamp-2-azimuthDeg').press('Tab');
    await app.expectReady();
    await expect(page.locator('.lamp-marks .sun')).toHaveCount(2);
  },
  'lamp-2-elevationDeg': async ({ app, at }) => {
    await at('lamp-2-elevationDeg').fill('25');
    await at('lamp-2-elevationDeg').press('Tab');
    await app.expectReady();
  },
  'lamp-2-strength': async ({ app, at }) => {
    await at('lamp-2-strength').fill('2');
    await at('lamp-2-strength').press('Tab');
    await app.expectReady();
    expect((await settingsFile(app)).settings.light[1]).toEqual({ azimuthDeg: 270, elevationDeg: 25, strength: 2 });
    await at('lamp-count').selectOption('Light of one lamp');
    await app.expectReady();
  },
  'lamp-1-strength': async ({ app, at }) => {
    await at('lamp-1-strength').fill('10');
    await at('lamp-1-strength').press('Tab');
    await app.expectReady();
    expect((await settingsFile(app)).settings.light).toEqual([{ azimuthDeg: 180, elevationDeg: 30, strength: 10 }]);
  },
  objective: async ({ app, at }) => {
    await at('objective').selectOption('one-light');
    await app.expectReady();
    expect((await settingsFile(app)).settings.objective).toBe('one-light');
    await at('objective').selectOption('contrast');
    await expect(at('lamp-count')).toHaveValue('0');
    await app.expectReady();
    expect((await settingsFile(app)).settings.light).toBeUndefined();
  },
  label: async ({ app, at }) => {
    await at('label').fill('No. 7');
    await at('label').press('Tab');
    await app.expectReady();
    expect((await settingsFile(app)).settings.label).toBe('No. 7');
    await at('label').fill('');
    await at('label').press('Tab');
    await app.expectReady();
  },
  frame: ({ app, at }) => chooseAndBack(app, at('frame'), 'frame', 'rounded'),
  mark: async ({ app, at }) => {
    await at('mark').selectOption('inlay');
    await app.expectReady();
    for (const id of ['preset', 'lamp-count', 'pattern', 'max-depth', 'surface']) await expect(at(id)).toBeHidden();
    await expect(at('min-wall')).toBeVisible();
    await app.openSettings();
    expect((await settingsFile(app)).settings).toMatchObject({ mark: 'inlay', preset: 'balanced' });
  },
  'mark-depth': async ({ app, at }) => {
    await at('mark-depth').fill('0.6');
    await at('mark-depth').press('Tab');
    await app.expectReady();
    expect((await settingsFile(app)).settings.markDepthMm).toBe(0.6);
    await at('mark').selectOption('paint');
    await expect(at('mark-depth')).toBeHidden();
    await expect(at('min-wall')).toBeHidden();
  },
  'dark-reflectance': async ({ app, at, page }) => {
    await expect(at('filament')).toBeVisible();
    await showOverlays(page, false);
    const inkShare = () => shareOf(app.canvas, isDark);
    await poll(inkShare).toBeGreaterThan(0.001);
    const before = await inkShare();
    await at('dark-reflectance').fill('0.6');
    await at('dark-reflectance').press('Tab');
    await app.expectReady();
    await poll(inkShare).toBeLessThan(before / 2);
    await showOverlays(page, true);
    expect((await settingsFile(app)).settings.darkReflectance).toBe(0.6);
    await at('mark').selectOption('shadow');
    await app.expectReady();
    await expect(at('dark-reflectance')).toBeHidden();
    await expect(at('preset')).toBeVisible();
    expect((await settingsFile(app)).settings).toMatchObject({ mark: 'shadow', darkReflectance: 0.6 });
  },
  'lay-face': async ({ app, at, press }) => {
    await app.canvas.scrollIntoViewIfNeeded();
    await press('lay-face');
    await expect(at('lay-hint')).toContainText('Click the face');
    await app.canvas.press('7'); // from a corner
    await app.canvas.press('Enter'); // the face in the middle
    await expect(at('lay-hint')).toBeHidden();
    await app.expectReady();
    await expect(at('build-up').locator('option:checked')).toHaveText('Chosen face down');
    expect((await settingsFile(app)).settings.buildUp).toHaveLength(3);
  },
  'lay-cancel': async ({ at, app, press }) => {
    await press('lay-face');
    await press('lay-cancel');
    await expect(at('lay-hint')).toBeHidden();
    await expect(at('lay-face')).toHaveAttribute('aria-pressed', 'false');
    await at('build-up').selectOption('as-modelled');
    await app.expectReady();
  },
  solver: ({ app, at }) => chooseAndBack(app, at('solver'), 'solver', 'paper-steps'),
  surface: ({ app, at }) => chooseAndBack(app, at('surface'), 'surface', 'resampled'),
  up: async ({ app, at }) => {
    await at('up').selectOption('−X');
    await app.expectReady();
    expect((await settingsFile(app)).settings.up).toEqual([-1, 0, 0]);
    await at('up').selectOption('Up axis of the model');
    await app.expectReady();
    expect((await settingsFile(app)).settings.up).toBeUndefined();
  },
  filament: async ({ app, at }) => {
    await at('filament').selectOption('White');
    await expect(at('albedo')).toHaveValue('0.85');
    await app.expectReady();
    expect((await settingsFile(app)).settings.albedo).toBe(0.85);
  },
  albedo: async ({ app, at }) => {
    await at('albedo').fill('0.62');
    await at('albedo').press('Tab');
    await expect(at('filament').locator('option:checked')).toHaveText('Other');
    await app.expectReady();
    expect((await settingsFile(app)).settings.albedo).toBe(0.62);
    await at('albedo').fill('');
    await at('albedo').press('Tab');
    await expect(at('filament').locator('option:checked')).toHaveText('Automatic');
    await app.expectReady();
    expect((await settingsFile(app)).settings.albedo).toBeUndefined();
  },
  'content-kind': async ({ app, at }) => {
    await at('content-kind').selectOption('Wi-Fi access');
    await expect(app.setting('Network name')).toBeVisible();
  },
  text: async ({ app, at }) => {
    const before = await at('symbol-facts').innerText();
    await at('text').fill('https://example.org/a-text-that-takes-more-modules-than-the-one-before');
    await expect(at('symbol-facts')).not.toHaveText(before);
    await app.expectReady();
  },
  'centre-x': ({ app, at, press }) => placeAt(app, at('centre-x'), '12', () => press('place-here')),
  'centre-y': ({ app, at }) => placeAt(app, at('centre-y'), '-7', () => at('centre-y').press('Enter')),
  'centre-z': ({ app, at, press }) => placeAt(app, at('centre-z'), '30', () => press('place-here')),
  'place-here': ({ app, at, press }) => placeAt(app, at('centre-x'), '9', () => press('place-here')),
  undo: async ({ app, press }) => {
    const before = await app.centre();
    await press('undo');
    await poll(() => app.centre()).not.toEqual(before);
    await app.expectReady();
  },
  redo: async ({ app, press }) => {
    const before = await app.centre();
    await press('redo');
    await poll(() => app.centre()).not.toEqual(before);
    await app.expectReady();
  },
  suggest: async ({ app, press }) => {
    await press('suggest');
    await expect(app.status).toHaveText('Choose a spot, or click the model.');
    await expect(app.spots).not.toHaveCount(0);
  },
  'show-sizes': async ({ page, press }) => {
    const legend = page.getByLabel('Colours of the model');
    await expect(legend).toContainText('Largest code that fits');
    await press('show-sizes');
    await expect(legend).toBeHidden();
  },
  'start-over': async ({ app, at, press }) => {
    await press('start-over');
    await expect(at('text')).toHaveValue('https://en.wikipedia.org/wiki/QR_code');
    await app.expectReady();
  },
};
