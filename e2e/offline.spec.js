// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { poll } from './support/poll.js';
import { Site } from './support/site.js';

/** @typedef {import('@playwright/test').Page} Page */

/** @type {Site} */ let site;
test.beforeEach(async () => {
  site = await new Site('/some/base/').open();
});
test.afterEach(() => site.close());
test.use({ serviceWorkers: 'allow' });

/** Waits until the page is kept on the device. @param {Page} page */
const untilKept = (page) => poll(() => page.evaluate(() => Boolean(navigator.serviceWorker.controller))).toBe(true);

test('A first visit transfers at most 2 MiB; then the page opens, engraves and decodes below any path and offline', async ({
  page,
  context,
}) => {
  const app = new Engraver(page);
  await page.goto(site.address);
  await app.expectReady();
  await untilKept(page);
  const bytes = site.sent.reduce((sum, file) => sum + file.bytes, 0);
  console.log(`first visit: ${(bytes / 1e6).toFixed(2)} MB by gzip in ${site.sent.length} files`);
  expect(bytes).toBeLessThan(2 * 2 ** 20);

  // Articles, other samples and other languages are kept once they are opened.
  await app.sample.selectOption('Vase');
  await expect(app.facts).toContainText('Vase');
  await page.goto(`${site.address}guide.html?lang=de`);
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('So wird es gedruckt');
  await site.close();
  await context.setOffline(true);

  await page.goto(`${site.address}?sample=bunny&text=without%20a%20network&process=none`);
  await app.expectReady();
  await app.engrave();
  await expect(app.result).toContainText('Reads as without a network');
  await app.sample.selectOption('Vase');
  await expect(app.facts).toContainText('Vase');
  await expect(app.alert).toHaveCount(0);
  await page.goto(`${site.address}guide.html?lang=de`);
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('So wird es gedruckt');
});

test('A new version is offered and takes over on request', async ({ page }) => {
  const app = new Engraver(page);
  await page.goto(`${site.address}?sample=pyramid`);
  await app.expectReady();
  await untilKept(page);
  site.changes.set('index.html', (html) => html.replace(/<title\b.*<\/title>/, '<title>The next version</title>'));
  site.changes.set('service_worker.js', (code) =>
    code.replace(/"version":"\w+"/, '"version":"next"').replace(/\["index.html","\w+"\]/, '["index.html","next"]'),
  );
  await page.reload();
  await expect(page.getByText('A new version is ready.')).toBeVisible();
  await expect(page).not.toHaveTitle('The next version');
  await page.getByRole('button', { name: 'Reload' }).click();
  await expect(page).toHaveTitle('The next version');
  await app.expectReady();
  await expect(page.getByText('A new version is ready.')).toHaveCount(0);
  const names = await page.evaluate(() => caches.keys());
  expect(names).toEqual([`qrelief ${site.address} next`]);
});

test('The page can be installed: a manifest with a name and icons of the sizes it states', async ({ page }) => {
  await page.goto(site.address);
  const address = await page
    .locator('link[rel="manifest"]')
    .evaluate((link) => /** @type {HTMLLinkElement} */ (link).href);
  const manifest = await (await page.request.get(address)).json();
  expect(manifest).toMatchObject({ short_name: 'QRelief', display: 'standalone', start_url: './', scope: './' });
  const measured = await page.evaluate(
    (icons) =>
      Promise.all(
        icons.map(async (/** @type {{ src: string }} */ { src }) => {
          const image = new Image();
          image.src = src;
          await image.decode();
          return `${image.naturalWidth}x${image.naturalHeight}`;
        }),
      ),
    manifest.icons.filter((/** @type {{ sizes: string }} */ { sizes }) => sizes !== 'any'),
  );
  expect(measured).toEqual(['192x192', '512x512', '512x512']);
  const touch = page.locator('link[rel="apple-touch-icon"]');
  const response = await page.request.get(await touch.evaluate((link) => /** @type {HTMLLinkElement} */ (link).href));
  expect(response.status()).toBe(200);
});
