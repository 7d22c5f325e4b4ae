// SPDX-License-Identifier: GPL-3.0-or-later
// Every control of the page has an effect, whether pressed with a mouse on a desktop or with a finger on a phone. Other
// specs check the full effect of each control; this one leaves out none. Controls that are not pressed are the same on
// both.
import { expect, test } from '@playwright/test';
import { kOfTheParts } from './support/batch_controls.js';
import { Engraver } from './support/engraver.js';
import { Inspector } from './support/inspector.js';
import { saddleFile, truncatedFile } from './support/models.js';
import { kOfThePage, kOfTheView } from './support/page_controls.js';
import { isDark, isOrange, isTeal, shareOf } from './support/pixels.js';
import { unzip } from './support/three_mf.js';
import { freeze, holdWorkers, thaw } from './support/workers.js';

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {import('./support/batch_controls.js').Hands} Hands */
/** @typedef {import('./support/batch_controls.js').Effects} Effects */

/** For each setting: the value to choose, its entry in the settings file, and the value to find in the report. */
const kSettings =
  /** @type {Record<string, { value: string | boolean, saved: Record<string, unknown>, reported?: (report: any) => unknown }>} */ ({
    ecc: { value: 'Q', saved: { ecc: 'Q' }, reported: ({ symbol }) => symbol.ecc },
    'quiet-zone': { value: false, saved: { quietZone: false } },
    rotate: { value: '10', saved: { rotateDeg: 10 }, reported: ({ size }) => size.rotationDeg },
    size: { value: 'fixed', saved: { size: 40 } },
    'size-mm': { value: '31', saved: { size: 31 }, reported: ({ size }) => size.symbolMm },
    direction: {
      value: 'mean-normal',
      saved: { direction: 'mean-normal' },
      reported: ({ projection }) => projection.method,
    },
    'eye-distance': {
      value: '300',
      saved: { eyeDistanceMm: 300 },
      reported: ({ projection }) => projection.eyeDistanceMm,
    },
    preset: { value: 'shallow', saved: { preset: 'shallow' } },
    pattern: { value: 'square', saved: { pattern: 'square' }, reported: ({ depth }) => depth.features.pattern },
    'finder-pattern': { value: 'diamond', saved: { finderPattern: 'diamond' } },
    contrast: { value: '0.28', saved: { contrast: 0.28 }, reported: ({ depth }) => depth.contrast },
    'carve-for': { value: 'design', saved: { carveFor: 'design' }, reported: ({ depth }) => depth.carvedFor },
    version: { value: '5', saved: { version: 5 }, reported: ({ symbol }) => symbol.version },
    mask: { value: '3', saved: { mask: 3 }, reported: ({ symbol }) => symbol.mask },
    'min-wall': { value: '1.5', saved: { minWallMm: 1.5 } },
    'max-depth': { value: '1.4', saved: { maxDepthMm: 1.4 } },
    process: { value: 'resin-0.05', saved: { process: 'resin-0.05' } },
    'build-up': { value: 'code-up', saved: { buildUp: 'code-up' } },
    nozzle: { value: '0.3', saved: { nozzleMm: 0.3 }, reported: ({ depth }) => depth.features.nozzleMm },
    layer: { value: '0.08', saved: { layerMm: 0.08 }, reported: ({ depth }) => depth.features.layerMm },
  });

/** Returns the contents of the file that Save settings saves. @param {Engraver} app */
const settingsFile = async (app) => JSON.parse(new TextDecoder().decode((await app.download('Save settings')).bytes));

/** @type {Effects} */
const kOfTheModel = {
  file: async ({ app, at }) => {
    await at('file').setInputFiles(saddleFile);
    await expect(app.facts).toContainText('my saddle.stl');
    await app.expectReady();
  },
  unit: async ({ app, at }) => {
    const before = await app.facts.innerText();
    await at('unit').selectOption('cm');
    await expect(app.facts).not.toHaveText(before);
    await at('unit').selectOption('mm');
    await expect(app.facts).toHaveText(before);
    await app.expectReady();
  },
  height: async ({ app, at }) => {
    const before = await app.facts.innerText(),
      height = await at('height').inputValue();
    await at('height').fill(String(2 * Number(height)));
    await at('height').press('Tab');
    await expect(at('unit')).toHaveValue('2');
    await expect(app.facts).not.toHaveText(before);
    await at('height').fill('-3');
    await at('height').press('Tab');
    await expect(at('height')).toHaveValue(String(2 * Number(height)));
    await at('unit').selectOption('1');
    await expect(app.facts).toHaveText(before);
    await app.expectReady();
  },
  'up-axis': async ({ app, at }) => {
    await at('up-axis').selectOption('y');
    await app.expectReady();
    expect((await settingsFile(app)).model.upAxis).toBe('y');
  },
  'alert-dismiss': async ({ app, at, press }) => {
    await at('file').setInputFiles(truncatedFile);
    await expect(app.alert).toContainText('is cut off');
    await press('alert-dismiss');
    await expect(app.alert).toBeHidden();
  },
  sample: async ({ app, at }) => {
    await at('sample').selectOption('bumpy-sphere');
    await expect(app.facts).toContainText('Bumpy sphere');
    await app.expectReady();
  },
};

/** Shows or hides buttons and legend over the view, whose colours the pictures would count. @param {Page} page @param {boolean} areShown */
const showOverlays = (page, areShown) =>
  page.locator('.tools, .legend, .view-cube').evaluateAll(
    (all, opacity) => {
      for (const one of all) /** @type {HTMLElement} */ (one).style.opacity = opacity;
    },
    areShown ? '1' : '0',
  );

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
  await expect.poll(() => app.centre()).not.toEqual(typed);
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

/** @type {Effects} */
const kOfThePlace = {
  'lamp-count': async ({ app, at, page }) => {
    await at('lamp-count').selectOption('Light of one lamp');
    await app.expectReady();
    await expect(page.locator('.lamp-marks circle')).toHaveCount(1);
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
    await expect(page.locator('.lamp-marks circle')).toHaveCount(2);
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
    await showOverlays(page, false);
    const inkShare = () => shareOf(app.canvas, isDark);
    await expect.poll(inkShare).toBeGreaterThan(0.001);
    const before = await inkShare();
    await at('dark-reflectance').fill('0.6');
    await at('dark-reflectance').press('Tab');
    await app.expectReady();
    await expect.poll(inkShare).toBeLessThan(before / 2);
    await showOverlays(page, true);
    expect((await settingsFile(app)).settings.darkReflectance).toBe(0.6);
  },
  'light-reflectance': async ({ app, at }) => {
    await at('light-reflectance').fill('0.7');
    await at('light-reflectance').press('Tab');
    await app.expectReady();
    expect((await settingsFile(app)).settings.lightReflectance).toBe(0.7);
    await at('mark').selectOption('shadow');
    await app.expectReady();
    await expect(at('light-reflectance')).toBeHidden();
    await expect(at('preset')).toBeVisible();
    expect((await settingsFile(app)).settings).toMatchObject({ mark: 'shadow', darkReflectance: 0.6 });
  },
  solver: ({ app, at }) => chooseAndBack(app, at('solver'), 'solver', 'paper-steps'),
  surface: ({ app, at }) => chooseAndBack(app, at('surface'), 'surface', 'resampled'),
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
  'place-here': ({ app, at, press }) => placeAt(app, at('centre-x'), '0', () => press('place-here')),
  undo: async ({ app, press }) => {
    const before = await app.centre();
    await press('undo');
    await expect.poll(() => app.centre()).not.toEqual(before);
    await app.expectReady();
  },
  redo: async ({ app, press }) => {
    const before = await app.centre();
    await press('redo');
    await expect.poll(() => app.centre()).not.toEqual(before);
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

/** @type {Effects} */
const kOfTheCarving = {
  fit: async ({ app, page, press }) => {
    const place = async () => (await app.moveHandle.boundingBox())?.x;
    const before = await place();
    await app.canvas.focus();
    for (let i = 0; i < 4; i += 1) await page.keyboard.press('Shift+ArrowRight');
    await expect.poll(place).not.toBe(before);
    await press('fit');
    await expect.poll(place).toBe(before);
  },
  'show-section': async ({ at, press }) => {
    await press('show-section');
    await expect(at('section-position')).toBeVisible();
  },
  'section-position': async ({ app, at, press }) => {
    await expect.poll(() => shareOf(app.canvas, isOrange)).toBeGreaterThan(0.005);
    const before = await shareOf(app.canvas, isOrange);
    await at('section-position').fill('0.9');
    await expect.poll(async () => Math.abs((await shareOf(app.canvas, isOrange)) / before - 1)).toBeGreaterThan(0.05);
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
    await expect.poll(() => shareOf(app.canvas, isTeal)).toBeGreaterThan(0.0013);
    await hold(at('show-before'), async () => {
      await expect(at('show-before')).toHaveAttribute('aria-pressed', 'true');
      await expect.poll(() => shareOf(app.canvas, isTeal)).toBeLessThan(0.001);
    });
    await expect.poll(() => shareOf(app.canvas, isTeal)).toBeGreaterThan(0.0013);
    await showOverlays(page, true);
  },
  'reader-view': async ({ page, press }) => {
    await press('reader-view');
    await expect(page.getByRole('group', { name: 'Phone view' })).toContainText('The phone reads');
  },
  inspector: async ({ page, press }) => {
    await press('inspector');
    await expect.poll(() => new Inspector(page).state()).toBeDefined();
    await press('inspector');
    await expect.poll(() => new Inspector(page).state()).toBeUndefined();
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
  download: async ({ page, press }) => {
    const [download] = await Promise.all([page.waitForEvent('download'), press('download')]);
    expect(download.suggestedFilename()).toMatch(/\.ply$/);
  },
  'save-report': async ({ page, press }) => {
    const [download] = await Promise.all([page.waitForEvent('download'), press('save-report')]);
    expect(download.suggestedFilename()).toMatch(/\.json$/);
  },
  cancel: async ({ app, at, page, press }) => {
    await at('text').fill('carved anew');
    await freeze(page); // otherwise the work may end before it is cancelled
    await press('engrave');
    await press('cancel');
    await expect(app.cancelButton).toBeHidden();
    await expect(app.status).toHaveText('Cancelled. The model is unchanged.');
    await thaw(page);
    await app.expectReady();
  },
};

/** Controls while all parts are carved; batch.spec.js checks their effects. */
const kOfTheRun = [
  'print-every',
  'carve-all',
  'parts-pause',
  'parts-resume',
  'parts-stop',
  'parts-retry',
  'parts-shown',
  'parts-download',
  'parts-discard',
];

/** @param {Page} page @returns {Promise<Hands>} */
async function open(page) {
  await page.addInitScript(holdWorkers);
  const app = new Engraver(page);
  await app.open('?sample=bumpy-sphere');
  await app.expectReady();
  await app.openSettings();
  const at = (/** @type {string} */ id) => page.locator(`#${id}, .views-menu [data-view="${id}"]`);
  const isTouched = await page.evaluate(() => navigator.maxTouchPoints > 0);
  return { app, page, at, press: (id) => (isTouched ? at(id).tap() : at(id).click()) };
}

/** @param {import('@playwright/test').Locator} button @param {() => Promise<void>} meanwhile */
async function hold(button, meanwhile) {
  await button.scrollIntoViewIfNeeded();
  const { x, y, width, height } = /** @type {{ x: number, y: number, width: number, height: number }} */ (
    await button.boundingBox()
  );
  const page = button.page();
  const point = { x: x + width / 2, y: y + height / 2 };
  if (await page.evaluate(() => navigator.maxTouchPoints > 0)) {
    const client = await page.context().newCDPSession(page);
    await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [point] });
    await meanwhile();
    await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  } else {
    await page.mouse.move(point.x, point.y);
    await page.mouse.down();
    await meanwhile();
    await page.mouse.up();
  }
}

/** @param {Hands} hands @param {Effects[]} parts */
async function tryAll(hands, ...parts) {
  for (const [id, effect] of parts.flatMap((effects) => Object.entries(effects)))
    await test.step(id, () => effect(hands));
}

test('Every control before the carving has its effect, and the test covers all', async ({ page }) => {
  const hands = await open(page);
  await tryAll(hands, kOfTheModel, kOfTheParts, kOfThePlace, kOfTheView, kOfThePage);

  const all = await page.evaluate(() =>
    [...document.querySelectorAll('button, input, select, textarea')]
      .filter((control) => control.getAttribute('type') !== 'hidden' && (control.id || control.closest('.views-menu')))
      .map((control) => control.id || String(control.getAttribute('data-view'))),
  );
  const tested = [kOfTheModel, kOfTheParts, kOfThePlace, kOfTheView, kOfTheCarving, kOfThePage, kSettings]
    .flatMap((part) => Object.keys(part))
    .concat(kOfTheRun);
  expect(all.filter((id) => !tested.includes(id))).toEqual([]);
  expect(tested.filter((id) => !all.includes(id))).toEqual([]);
});

test('Every setting is saved and carved with, and every control of the carving has its effect', async ({ page }) => {
  const hands = await open(page);
  const { app, at, press } = hands;
  const isPhone = test.info().project.name === 'phone';
  const settings = Object.entries(kSettings).filter(([, { value }]) => !isPhone || typeof value === 'boolean');
  let before = (await settingsFile(app)).settings;
  for (const [id, setting] of settings) {
    await test.step(id, async () => {
      const control = at(id);
      if (typeof setting.value === 'boolean') await press(id);
      else if (await control.evaluate((element) => element.tagName === 'SELECT'))
        await control.selectOption(setting.value);
      else await control.fill(setting.value);
      await control.blur();
      const after = (await settingsFile(app)).settings;
      expect(after).not.toEqual(before);
      expect(after).toMatchObject(setting.saved);
      before = after;
    });
  }
  await app.expectReady();
  const { cancel, ...others } = kOfTheCarving;
  await tryAll(hands, others);
  const report = await app.report();
  for (const [id, { saved: wanted, reported }] of settings)
    if (reported) expect(reported(report), id).toBe(Object.values(wanted)[0]);
  await tryAll(hands, { cancel });
});
