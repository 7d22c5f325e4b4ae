// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';

test('On a phone a tap places the code, a pinch does not, and the result can be reached', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=bumpy-sphere');
  await app.expectReady();
  const before = await app.centre();
  const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await app.canvas.boundingBox());
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];

  await pinch(page, x, y, 40, 80);
  expect(await app.centre()).toEqual(before);

  await page.touchscreen.tap(x + 10, y + 10);
  await expect.poll(() => app.centre()).not.toEqual(before);
  await app.expectReady();

  await app.engrave();
  await expect(app.result).toContainText('Reads as');
  await expect(page.getByRole('button', { name: 'Download' })).toBeInViewport();
  expect((await app.download()).bytes.length).toBeGreaterThan(84);
});

test('On a phone every button over the view is at least 44 pixels high and inside the screen', async ({ page }) => {
  const app = new Engraver(page);
  await app.open();
  for (const name of ['Carved', 'Reader’s view', 'Fit', 'Inspector']) {
    const box = await page.getByRole('button', { name }).boundingBox();
    expect(box?.height).toBeGreaterThanOrEqual(44);
    expect((box?.x ?? -1)).toBeGreaterThanOrEqual(0);
    expect((box?.x ?? 0) + (box?.width ?? 1000)).toBeLessThanOrEqual(360);
  }
});

/**
 * Two fingers about (x, y), from one distance to another.
 * @param {import('@playwright/test').Page} page
 * @param {number} x
 * @param {number} y
 * @param {number} from
 * @param {number} to
 */
async function pinch(page, x, y, from, to) {
  const client = await page.context().newCDPSession(page);
  const fingers = (/** @type {number} */ distance) => [
    { x: x - distance / 2, y, id: 0 }, { x: x + distance / 2, y, id: 1 },
  ];
  await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: fingers(from) });
  for (let step = 1; step <= 5; step += 1) {
    const touchPoints = fingers(from + ((to - from) * step) / 5);
    await client.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints });
  }
  await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await client.detach();
}
