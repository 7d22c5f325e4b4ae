// SPDX-License-Identifier: GPL-3.0-or-later
// Takes a picture of every state of the built page for visual checks, and the pictures for README and guide:
// `script/pictures`.
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium, expect as expectFrom } from '@playwright/test';
import { Engraver } from './engraver.js';
import { openFile, truncatedFile } from './models.js';
import { Site } from './site.js';

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {(app: Engraver, page: Page, shoot: () => Promise<void>) => Promise<void>} Walk  `shoot`: takes a frame of a film */

const kRoot = fileURLToPath(new URL('../../', import.meta.url));
const kSettleMs = 2500; // for the view to refine its picture

/** @type {Record<string, import('@playwright/test').BrowserContextOptions>} */
const kLooks = {
  'desktop-light': { viewport: { width: 1280, height: 800 }, colorScheme: 'light' },
  'desktop-dark': { viewport: { width: 1280, height: 800 }, colorScheme: 'dark' },
  'phone-light': {
    viewport: { width: 360, height: 740 },
    hasTouch: true,
    isMobile: true,
    deviceScaleFactor: 2,
    colorScheme: 'light',
  },
  'phone-dark': {
    viewport: { width: 360, height: 740 },
    hasTouch: true,
    isMobile: true,
    deviceScaleFactor: 2,
    colorScheme: 'dark',
  },
  view: { viewport: { width: 1060, height: 560 }, colorScheme: 'light', bypassCSP: true },
};

const expect = expectFrom.configure({ timeout: 60_000 });

/** @param {Page} page @param {string} name */
const press = (page, name) => page.getByRole('button', { name, exact: true }).click();

/** @param {Engraver} app @param {Page} page */
async function engraveAndPrint(app, page) {
  await app.engrave();
  await expect(page.locator('.verdict .under-way')).toHaveCount(0);
}

/** Follows the code from the pointer to the carved model, in six frames. @type {Walk} */
async function followCode(app, page, shoot) {
  const box = await app.canvas.boundingBox();
  if (!box) throw new Error('The view has no size');
  const at = (/** @type {number} */ x, /** @type {number} */ y) => [box.x + x * box.width, box.y + y * box.height];
  const depths = app.chip.getByText('mm at most');
  await app.showLive();
  const [x, y] = at(0.66, 0.7);
  await page.mouse.move(x - 6, y - 6);
  await page.mouse.move(x, y);
  await expect(app.chip).toBeVisible();
  await shoot(); // where the code would lie
  await expect(depths).toBeVisible();
  await shoot(); // as it will be carved
  const [toX, toY] = at(0.29, 0.41);
  await page.mouse.move(toX - 6, toY);
  await page.mouse.move(toX, toY);
  await expect(depths).toBeVisible();
  await shoot(); // elsewhere
  await page.mouse.click(toX, toY);
  await expect(app.status).toHaveText('Ready.');
  await page.mouse.move(2, 2);
  await expect(page.locator('#placement-depth')).toBeVisible();
  await shoot(); // placed there
  await app.engraveButton.click();
  await expect(app.status).toContainText('Finding the depth');
  await shoot(); // the search goes on
  await app.expectResult();
  await page.waitForTimeout(kSettleMs);
  await shoot(); // carved
}

const kPlate = '?sample=plate&text=QRelief';

/** @param {Engraver} app @param {Page} page @param {Record<string, string>} settings  by the names of their controls */
async function seePrint(app, page, settings) {
  await app.openSettings();
  for (const [name, value] of Object.entries(settings)) await app.setting(name).selectOption(value);
  await engraveAndPrint(app, page);
  await press(page, 'Phone view');
  await press(page, 'As printed');
}

/**
 * The states. Each walk starts on a freshly opened page and ends in the state to be shown.
 * @type {Record<string, { query?: string, walk: Walk, wholePage?: boolean }>}
 */
const kStates = {
  ready: { walk: async () => {} },
  settings: { walk: async (app) => app.openSettings(), wholePage: true },
  hover: {
    walk: async (app, page) => {
      const box = await app.canvas.boundingBox();
      if (!box) throw new Error('The view has no size');
      await page.mouse.move(box.x + 0.4 * box.width, box.y + 0.4 * box.height, { steps: 4 });
      await expect(app.chip).toBeVisible();
    },
  },
  film: { walk: followCode },
  spots: { walk: async (app) => app.suggest() },
  wifi: {
    walk: async ({ page }) => {
      await page.getByRole('combobox', { name: 'Kind of content' }).selectOption('Wi-Fi access');
      await page.getByLabel('Network name').fill('workshop');
    },
  },
  carving: {
    walk: async (app) => {
      await app.engraveButton.click();
      await expect(app.status).toContainText('Finding the depth');
    },
  },
  result: { walk: engraveAndPrint },
  'result-page': { walk: engraveAndPrint, wholePage: true },
  printing: { walk: async (app) => app.engrave() },
  depths: {
    walk: async (app, page) => {
      await app.engrave();
      await press(page, 'Depths');
    },
  },
  section: {
    walk: async (app, page) => {
      await app.engrave();
      await press(page, 'Section');
    },
  },
  reader: {
    walk: async (app, page) => {
      await app.engrave();
      await press(page, 'Phone view');
    },
  },
  painted: {
    walk: async (app, page) => {
      await app.setting('Made by').selectOption('Second colour, painted');
      await expect(app.status).toHaveText('Ready.');
      await engraveAndPrint(app, page);
    },
  },
  printed: { walk: (app, page) => seePrint(app, page, {}) },
  'printed-standing': {
    query: kPlate,
    walk: (app, page) => seePrint(app, page, { 'Orientation on the printer': 'code-upright' }),
  },
  'printed-lying': {
    query: kPlate,
    walk: (app, page) => seePrint(app, page, { 'Orientation on the printer': 'code-up' }),
  },
  'printed-fine': {
    query: kPlate,
    walk: (app, page) => seePrint(app, page, { Process: 'fdm-0.25/0.1', 'Orientation on the printer': 'code-up' }),
  },
  'printed-resin': {
    query: kPlate,
    walk: (app, page) => seePrint(app, page, { Process: 'resin-0.05', 'Orientation on the printer': 'code-up' }),
  },
  'printed-painted': {
    query: kPlate,
    walk: (app, page) =>
      seePrint(app, page, { 'Made by': 'Second colour, painted', 'Orientation on the printer': 'code-up' }),
  },
  unread: {
    query: '?sample=bunny&text=too%20small',
    walk: async (app) => {
      await app.openSettings();
      await app.setting('Contrast').fill('0.05');
      await app.setting('Contrast').press('Tab');
      await app.engrave();
    },
    wholePage: true,
  },
  broken: { walk: async (app) => app.file.setInputFiles(truncatedFile) },
  open: { walk: async (app) => app.file.setInputFiles(openFile) },
  help: { walk: async ({ page }) => press(page, 'Help') },
  inspector: {
    walk: async (app, page) => {
      await app.openSettings();
      await app.engrave();
      await press(page, 'Inspector');
    },
  },
};

/** Pictures for README and guide: of the page, or of the view alone without the buttons over it. */
const kShown = [
  { file: 'docs/engraved_bunny.png', state: 'result', look: 'desktop-light' },
  { file: 'docs/suggested_spots.jpg', state: 'spots', look: 'desktop-dark' },
  { file: 'docs/phone.jpg', state: 'reader', look: 'phone-light' },
  { file: 'docs/painted_code.jpg', state: 'painted', look: 'view' },
  { file: 'web/guide/pictures/live.jpg', state: 'film', look: 'view' },
  { file: 'web/guide/pictures/place.jpg', state: 'ready', look: 'view' },
  { file: 'web/guide/pictures/carved.jpg', state: 'result', look: 'view' },
  { file: 'web/guide/pictures/read.jpg', state: 'reader', look: 'view' },
  { file: 'web/guide/pictures/printed_standing.jpg', state: 'printed-standing', look: 'view' },
  { file: 'web/guide/pictures/printed_lying.jpg', state: 'printed-lying', look: 'view' },
  { file: 'web/guide/pictures/printed_fine.jpg', state: 'printed-fine', look: 'view' },
  { file: 'web/guide/pictures/printed_resin.jpg', state: 'printed-resin', look: 'view' },
  { file: 'web/guide/pictures/painted.jpg', state: 'painted', look: 'view' },
  { file: 'web/guide/pictures/printed_painted.jpg', state: 'printed-painted', look: 'view' },
];

/** Returns a picture of the view without the buttons over it. @param {Page} page */
async function viewOf(page) {
  await page.addStyleTag({ content: '.tools, .view-cube, .reader-view p, .of-print { visibility: hidden; }' });
  const clip = await page.getByRole('main').boundingBox();
  if (!clip) throw new Error('The view has no size');
  return page.screenshot({ clip, type: 'jpeg', quality: 82 });
}

/** Writes frames as one picture, three in a row. @param {Page} page @param {Buffer[]} frames @param {string} file */
async function writeFilm(page, frames, file) {
  const images = frames.map((frame) => `<img src="data:image/jpeg;base64,${frame.toString('base64')}">`);
  await page.setContent(`<style>
    body { margin: 0; display: grid; grid-template-columns: repeat(3, 320px); gap: 2px; width: max-content; align-content: start; }
    img { width: 320px; display: block; }
  </style>${images.join('')}`);
  await page.locator('body').screenshot({ path: file, type: 'jpeg', quality: 82 });
}

/**
 * @param {import('@playwright/test').Browser} browser
 * @param {Site} site
 * @param {{ state: string, look: string, file: string }} picture
 */
async function take(browser, site, { state, look, file }) {
  const { query = '?sample=bunny', walk, wholePage = false } = kStates[state];
  const context = await browser.newContext({
    ...kLooks[look],
    baseURL: site.address,
    locale: 'en',
    serviceWorkers: 'block',
  });
  try {
    const page = await context.newPage();
    const app = new Engraver(page);
    await app.open(query);
    await expect(app.status).toHaveText('Ready.');
    /** @type {Buffer[]} */ const frames = [];
    await walk(app, page, async () => void frames.push(await viewOf(page)));
    if (state !== 'carving') await page.waitForTimeout(kSettleMs);
    const path = kRoot + file;
    mkdirSync(dirname(path), { recursive: true });
    if (frames.length > 0) await writeFilm(page, frames, path);
    else if (look === 'view') writeFileSync(path, await viewOf(page));
    else await page.screenshot({ path, fullPage: wholePage });
  } finally {
    await context.close();
  }
}

/** @param {string | undefined} wantedState @param {string} [wantedLook]  of pictures that are shown: part of their file */
const chosen = (wantedState, wantedLook = '') =>
  wantedState === 'shown'
    ? kShown.filter(({ file }) => file.includes(wantedLook))
    : Object.keys(kStates)
        .filter((name) => !wantedState || name === wantedState)
        .flatMap((state) =>
          Object.keys(kLooks)
            .filter((name) => name !== 'view' && name.startsWith(wantedLook))
            .map((look) => ({ file: `build/pictures/${state}-${look}.png`, state, look })),
        );

const site = await new Site('/').open();
let failed = false;
try {
  for (const picture of chosen(.../** @type {[string | undefined, string?]} */ (process.argv.slice(2)))) {
    const browser = await chromium.launch({
      // a new browser for each: software rendering never frees its memory
      executablePath: process.env.QRELIEF_CHROMIUM ?? '/usr/bin/chromium',
      args: [
        '--use-angle=swiftshader',
        '--enable-unsafe-swiftshader',
        '--no-sandbox',
        '--disable-background-networking',
      ],
    });
    try {
      await take(browser, site, picture);
      console.log(picture.file);
    } catch (thrown) {
      failed = true;
      console.error(`${picture.file}: ${thrown instanceof Error ? thrown.message.split('\n')[0] : thrown}`);
    } finally {
      await browser.close();
    }
  }
} finally {
  await site.close();
}
process.exitCode = failed ? 1 : 0;
