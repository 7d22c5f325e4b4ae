// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { writeStl } from '../web/samples/stl.js';
import { Engraver } from './support/engraver.js';
import { saddleMesh, truncatedFile } from './support/models.js';
import { poll } from './support/poll.js';
import { readPng } from './support/read_png.js';

/** Returns the mean brightness in the view's lower left corner, 0 … 255. @param {import('@playwright/test').Page} page */
async function cornerBrightness(page) {
  const { width, height, channels, data } = readPng(
    await page.screenshot({ clip: { x: 4, y: 540, width: 40, height: 40 } }),
  );
  return data.reduce((sum, value, i) => (i % channels === 3 ? sum : sum + value), 0) / (3 * width * height);
}

test('Another language applies at once, also to numbers, and is kept', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  await page.getByRole('combobox', { name: 'Language' }).selectOption('Deutsch');
  await expect(page.locator('html')).toHaveAttribute('lang', 'de');
  await expect(page.getByRole('button', { name: 'Gravieren' })).toBeEnabled();
  await expect(app.facts).toHaveText('Sattel, 90,0 × 90,0 × 40,0 mm');
  await expect(app.placement).toHaveText(/^\d+,\d\smm breit$/);
  await expect(app.status).toHaveText('Bereit.');
  await expect(page.getByRole('combobox', { name: 'Beispielmodell' })).toHaveValue('saddle');
  await expect(page).toHaveTitle(/einen QR-Code/);

  await page.reload();
  await expect(page.getByRole('button', { name: 'Gravieren' })).toBeVisible();

  await test.step('a machine’s translation says so, and is complete', async () => {
    await page.getByRole('combobox', { name: 'Sprache' }).selectOption('Français (traduction automatique)');
    await expect(page.getByRole('button', { name: 'Graver', exact: true })).toBeEnabled();
    await expect(app.placement).toHaveText(/^\d+,\d\smm /);
  });
});

test('Findings and errors are in the chosen language, and one click rescales a tiny model to a printable unit', async ({
  page,
}) => {
  const positions = saddleMesh.positions.map(
    (point) => /** @type {[number, number, number]} */ (point.map((v) => v / 1000)),
  );
  const metres = {
    name: 'metres.stl',
    mimeType: 'model/stl',
    buffer: Buffer.from(writeStl({ ...saddleMesh, positions }, 'in metres')),
  };
  const app = new Engraver(page);
  await app.open('?sample=saddle&lang=de');
  await expect(app.status).toHaveText('Bereit.');
  await page.getByLabel('Modelldatei').setInputFiles(metres);
  const german = page.getByRole('list', { name: 'Im Modell gefunden' });
  await expect(german).toContainText('Das Modell ist winzig: 0,09 × 0,09 × 0,04 mm.');
  await expect(german.getByRole('button', { name: 'In Metern lesen: 90 × 90 × 40 mm' })).toBeVisible();
  await page.getByLabel('Modelldatei').setInputFiles(truncatedFile);
  await expect(app.alert).toContainText(/Dreieck/);
  await page.getByRole('combobox', { name: 'Sprache' }).selectOption('English');
  await expect(app.alert).toContainText(/facets|triangles/);

  const findings = page.getByRole('list', { name: 'Found in the model' });
  await expect(findings).toContainText(
    'The model is tiny: 0.09 × 0.09 × 0.04 mm. If it should be larger, choose another unit: in metres it is 90 × 90 × 40 mm.',
  );
  await expect(findings).not.toContainText('--');
  await findings.getByRole('button', { name: 'Read it in metres: 90 × 90 × 40 mm' }).click();
  await expect(app.facts).toHaveText('metres.stl, 90.0 × 90.0 × 40.0 mm');
  await expect(findings.getByRole('listitem')).toHaveCount(0);
  await app.expectReady();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(app.facts).toHaveText(/metres\.stl, 0\.09/);

  await test.step('a model that stands on its y axis is turned by one click', async () => {
    const onItsSide = writeStl(
      {
        positions: [
          [-20, 0, -20],
          [20, 0, -20],
          [20, 0, 20],
          [-20, 0, 20],
          [0, 50, 0],
        ],
        triangles: [
          [0, 1, 2],
          [0, 2, 3],
          [0, 4, 1],
          [1, 4, 2],
          [2, 4, 3],
          [3, 4, 0],
        ],
      },
      'y up',
    );
    await app.file.setInputFiles({ name: 'side.stl', mimeType: 'model/stl', buffer: Buffer.from(onItsSide) });
    await expect(findings).toContainText('The model has a flat base at its lowest y, but none at its lowest z.');
    await findings.getByRole('button', { name: 'Turn: y is up' }).click();
    await expect(page.getByLabel('Up axis')).toHaveValue('y');
    await expect(findings).not.toContainText('flat base');
  });
});

test('The page works without browser storage, and the address can choose a language', async ({ page }) => {
  /** @type {string[]} */ const complaints = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  await page.addInitScript(() => {
    for (const storage of ['localStorage', 'indexedDB']) {
      Object.defineProperty(window, storage, {
        get: () => {
          throw new DOMException('denied', 'SecurityError');
        },
      });
    }
  });
  const app = new Engraver(page);
  await app.open('?lang=de'); // without other parameters, the page looks for the last visit's work
  await expect(app.status).toHaveText('Bereit.');
  await page.getByRole('combobox', { name: 'Sprache' }).selectOption('English');
  await expect(page.getByRole('button', { name: 'Engrave', exact: true })).toBeVisible();
  await page.getByRole('combobox', { name: 'Appearance' }).selectOption('Dark');
  await app.sample.selectOption('Saddle');
  await expect(app.facts).toContainText('90.0 × 90.0 × 40.0 mm');
  await app.expectReady();
  await expect(app.alert).toHaveCount(0);
  expect(complaints).toEqual([]);
});

test('A chosen appearance overrides the device’s, also in the 3D view, and is kept', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  const ground = () => page.locator('#panel').evaluate((panel) => getComputedStyle(panel).backgroundColor);
  expect(await ground()).toBe('rgb(255, 255, 255)');
  expect(await cornerBrightness(page)).toBeGreaterThan(180);
  await page.getByRole('combobox', { name: 'Appearance' }).selectOption('Dark');
  await poll(ground).toBe('rgb(30, 33, 37)');
  await poll(() => cornerBrightness(page)).toBeLessThan(80);

  await page.reload();
  await expect(page.getByRole('combobox', { name: 'Appearance' })).toHaveValue('dark');
  expect(await ground()).toBe('rgb(30, 33, 37)');

  // The appearance is right at the first paint, before any of the page's modules has loaded.
  await page.route(/\/assets\/.*\.js$/, (route) => route.abort());
  await page.goto('about:blank');
  await app.open('');
  expect(await ground()).toBe('rgb(30, 33, 37)');
});
