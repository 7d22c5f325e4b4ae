// SPDX-License-Identifier: GPL-3.0-or-later
// Opens the page and presses controls as a user does: with a mouse on a desktop, with a finger on a phone.
import { expect } from '@playwright/test';
import { Engraver } from './engraver.js';
import { holdWorkers } from './workers.js';

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {{ app: Engraver, page: Page, at: (id: string) => import('@playwright/test').Locator, press: (id: string) => Promise<void> }} Hands */
/**
 * @typedef {Record<string, (hands: Hands) => Promise<void>>} Effects  by the id of the control or the side it shows;
 *   run in this order
 */

/** @param {Page} page @returns {Promise<Hands>} */
export async function openWithHands(page) {
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
export async function hold(button, meanwhile) {
  await expect(button).toBeEnabled(); // neither a mouse that goes down nor a touch waits for that
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

/** Returns the contents of the file that Save settings saves. @param {Engraver} app */
export const settingsFile = async (app) =>
  JSON.parse(new TextDecoder().decode((await app.download('Save settings')).bytes));

/** Shows or hides buttons and legend over the view, whose colours the pictures would count. @param {Page} page @param {boolean} areShown */
export const showOverlays = (page, areShown) =>
  page.locator('.tools, .legend, .view-cube').evaluateAll(
    (all, opacity) => {
      for (const one of all) /** @type {HTMLElement} */ (one).style.opacity = opacity;
    },
    areShown ? '1' : '0',
  );
