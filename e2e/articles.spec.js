// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { expectNoViolations } from './support/axe.js';
import { Engraver } from './support/engraver.js';
import { readPng } from './support/read_png.js';

test.use({ deviceScaleFactor: 1 }); // on a phone, too: no test here looks at the screen’s pixels

/** @typedef {import('@playwright/test').Page} Page */

/**
 * Expects that a table which is wider than the screen is darker at the edge where it goes on, and only there.
 * @param {import('@playwright/test').Locator} region
 */
async function expectShadowWhereItGoesOn(region) {
  const edges = async () => {
    const { width, height, channels, data } = readPng(await region.screenshot());
    const lightest = (/** @type {number} */ x) =>
      Math.max(...Array.from({ length: height - 4 }, (_, y) => data[((y + 2) * width + x) * channels + 1])); // inside
    const middle = lightest(Math.floor(width / 2));
    return [2, width - 3].map((x) => lightest(x) < middle - 20);
  };
  expect(await edges()).toEqual([false, true]);
  await region.evaluate((element) => element.scrollTo({ left: element.scrollWidth }));
  expect(await edges()).toEqual([true, false]);
}

/** Collects the page's errors. @param {Page} page */
function listen(page) {
  /** @type {string[]} */ const complaints = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  return complaints;
}

/** @param {Page} page */
async function expectNoSidewaysScroll(page) {
  expect(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth)).toBe(
    0,
  );
}

test('The guide lists code widths, and its plate opens carved in the app', async ({ page }) => {
  const complaints = listen(page);
  const app = new Engraver(page);
  await app.open('?sample=pyramid');
  await app.expectReady();
  await page.getByRole('link', { name: 'How to print it' }).click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('How to print it');
  const row = page.getByRole('table', { name: 'Width of the code' }).getByRole('row', { name: '42 letters' });
  await expect(row).toContainText(/29 × 29\s*17\.4\smm\s*34\.8\smm/);
  await expectNoSidewaysScroll(page);
  await expectNoViolations(page, 'guide');
  if (test.info().project.name === 'phone') {
    // the rest does not depend on the layout
    expect(complaints).toEqual([]);
    return;
  }
  await page.getByRole('link', { name: 'Open the engraved plate' }).click();
  await app.expectResult();
  await expect(app.result).toContainText('Reads as QRelief');

  await test.step('in German if that is the chosen language', async () => {
    await page.goto('./guide.html');
    await page.getByLabel('Language').selectOption('de');
    await expect(page.getByRole('heading', { level: 1 })).toHaveText('So wird es gedruckt');
    await expect(page.getByRole('table').first()).toContainText('17,4 mm');
    await page.getByRole('link', { name: 'So funktioniert es' }).click();
    await expect(page.getByRole('heading', { level: 1 })).toHaveText('So funktioniert es');
    await expect(page).toHaveTitle(/funktioniert/);
  });
  expect(complaints).toEqual([]);
});

test('The method page computes its pictures and decodes the phone’s view', async ({ page }) => {
  const complaints = listen(page);
  await page.goto('./method.html');
  await expect(page.getByRole('status')).toHaveText(/^Done in [\d.]+ seconds\.$/, { timeout: 300_000 });
  await expect(page.getByText('Decoded: https://en.wikipedia.org/wiki/QR_code')).toBeVisible();
  for (const name of [
    /Normals of the surface/,
    /Height above the plane/,
    /The light on the floors/,
    /The final depths/,
    /The phone’s view/,
  ]) {
    const colours = await page.getByRole('img', { name }).evaluate((element) => {
      const canvas = /** @type {HTMLCanvasElement} */ (element);
      const pixels =
        canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data ?? new Uint8ClampedArray();
      return new Set(new Uint32Array(pixels.buffer)).size;
    });
    expect(colours, String(name)).toBeGreaterThan(20);
  }
  await expect(page.getByText('closed, manifold, no crossings')).toBeVisible();
  await expect(page.getByText('14,696')).toBeVisible();
  await expectNoSidewaysScroll(page);
  await expectNoViolations(page, 'method');
  expect(complaints).toEqual([]);
});

test('The method page leads to the pages of the library, and its example to the function it calls', async ({
  page,
}) => {
  const complaints = listen(page);
  await page.goto('./method.html');
  await page.getByRole('link', { name: 'The C++ library for developers' }).click();
  await expect(page).toHaveTitle('The library · QRelief');
  await expect(page.getByRole('listitem').filter({ hasText: 'depth search' })).toHaveText(/^depth: /);
  await expectNoSidewaysScroll(page);
  await expectNoViolations(page, 'library');
  await page.getByRole('link', { name: 'readModel', exact: true }).click();
  await expect(page).toHaveTitle('io · QRelief');
  await expect(page.getByRole('heading', { name: 'readModel()' })).toBeInViewport();
  await expectNoSidewaysScroll(page);
  await expectNoViolations(page, 'module of the library');
  expect(complaints).toEqual([]);
});

test('The study shows figures with downloadable tables, in the page’s language and width', async ({ page }) => {
  const complaints = listen(page);
  await page.goto('./guide.html');
  await page.getByRole('link', { name: 'Measurements' }).click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Measurements');
  const width = test.info().project.name === 'phone' ? 'narrow' : 'wide';

  /** @param {string} language */
  const expectFigures = async (language) => {
    const figures = page.getByRole('figure');
    await expect(figures).not.toHaveCount(0); // the page is long, and may still be arriving
    for (const figure of await figures.all()) {
      const picture = figure.getByRole('img');
      await picture.scrollIntoViewIfNeeded();
      const drawn = await picture.evaluate(async (element) => {
        const image = /** @type {HTMLImageElement} */ (element);
        await image.decode();
        return { source: image.currentSrc, wide: image.naturalWidth, alt: image.alt };
      });
      expect(drawn.source).toContain(`.${language}.${width}.svg`);
      expect(drawn.wide).toBeGreaterThan(200);
      expect(drawn.alt).not.toBe('');
      const table = await figure.getByRole('link', { name: 'CSV' }).getAttribute('href');
      const rows = (await (await page.request.get(String(table))).text()).trim().split('\n');
      await expect(figure.getByRole('link', { name: 'CSV' })).toContainText((rows.length - 1).toLocaleString(language));
    }
    await expectNoSidewaysScroll(page);
  };
  await expectFigures('en');
  if (width === 'narrow') await expectShadowWhereItGoesOn(page.getByRole('region', { name: 'CarvedQR', exact: true }));
  await expectNoViolations(page, 'study');
  await page.getByLabel('Language').selectOption('de');
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Messungen');
  await expectFigures('de');
  await expectNoViolations(page, 'study, German');
  expect(complaints).toEqual([]);
});
