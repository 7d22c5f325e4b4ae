// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { Inspector } from './support/inspector.js';
import { poll } from './support/poll.js';

test('On a phone, fingers place, move and turn the code, and the result is reachable', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=bumpy-sphere');
  await app.expectReady();

  await test.step('every button over the view is at least 44 pixels high and inside the screen', async () => {
    for (const name of ['Views', 'Phone view', 'Fit', 'Section', 'Plate']) {
      const box = await page.getByRole('button', { name }).boundingBox();
      expect(box?.height).toBeGreaterThanOrEqual(44);
      expect(box?.x ?? -1).toBeGreaterThanOrEqual(0);
      expect((box?.x ?? 0) + (box?.width ?? 1000)).toBeLessThanOrEqual(360);
    }
  });

  await test.step('a finger on the grip moves the code, and a second one turns it', async () => {
    const before = await app.centre();
    const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (
      await app.moveHandle.boundingBox()
    );
    expect(box.width).toBeGreaterThanOrEqual(44);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const client = await page.context().newCDPSession(page);
    const touch = (
      /** @type {'touchStart' | 'touchMove' | 'touchEnd'} */ type,
      /** @type {[number, number][]} */ ...points
    ) =>
      client.send('Input.dispatchTouchEvent', {
        type,
        touchPoints: points.map(([px, py], id) => ({ x: px, y: py, id })),
      });
    await touch('touchStart', [x, y]);
    await touch('touchMove', [x + 12, y + 8]);
    await touch('touchMove', [x + 20, y + 12]);
    await expect(app.chip).toContainText('mm wide');
    await touch('touchEnd');
    await poll(() => app.centre()).not.toEqual(before);
    await app.expectReady();

    const moved = await app.centre();
    const grip = /** @type {{ x: number, y: number }} */ (await app.moveHandle.boundingBox());
    /** @type {[number, number]} */ const first = [grip.x + box.width / 2, grip.y + box.height / 2];
    await touch('touchStart', first);
    await touch('touchStart', first, [first[0] + 80, first[1]]);
    await touch('touchMove', first, [first[0] + 60, first[1] - 60]);
    await touch('touchEnd');
    await poll(() => app.rotation()).toBeGreaterThan(40);
    expect(await app.rotation()).toBeLessThan(50);
    expect(await app.centre()).toEqual(moved);
  });

  await test.step('a tap places the code, a pinch does not', async () => {
    const before = await app.centre();
    const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await app.canvas.boundingBox());
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];

    await pinch(page, x, y, 40, 80);
    expect(await app.centre()).toEqual(before);

    await page.touchscreen.tap(x + 10, y + 10);
    await poll(() => app.centre()).not.toEqual(before);
    await app.expectReady();
  });

  await test.step('the result is reachable', async () => {
    await app.engrave();
    await expect(app.result).toContainText('Reads as');
    await expect(app.downloadButton).toBeInViewport();
    expect((await app.download()).bytes.length).toBeGreaterThan(84);
  });

  await test.step('in the phone view, sideways too, the switch to the print lies above the code', async () => {
    const change = page.getByRole('group', { name: 'The engraved model or its print' });
    for (const size of [
      { width: 360, height: 740 },
      { width: 740, height: 360 },
    ]) {
      await page.setViewportSize(size);
      await page.getByRole('button', { name: 'Phone view' }).tap();
      await expect(change).toBeVisible();
      const [over, frame] = await Promise.all([change, page.locator('.finder')].map((one) => one.boundingBox()));
      if (!over || !frame) throw new Error('The phone view has no size');
      expect(over.y + over.height).toBeLessThanOrEqual(frame.y + frame.height / 8); // the quiet zone's part of it
    }
    await page.setViewportSize({ width: 360, height: 740 });
    await page.getByRole('button', { name: 'Fit' }).tap();
    await expect(change).toBeHidden();
  });

  await test.step('the inspector opens beside the buttons, and its tabs can be tapped', async () => {
    const inspector = new Inspector(page);
    await inspector.open();
    const { window } = /** @type {import('../web/engine/types.js').InspectorState} */ (await inspector.state());
    const canvas = /** @type {{ x: number, y: number, width: number, height: number }} */ (
      await app.canvas.boundingBox()
    );
    const tools = /** @type {{ x: number, y: number, width: number, height: number }} */ (
      await page.getByRole('toolbar', { name: 'View' }).boundingBox()
    );
    expect(canvas.y + window[1] >= tools.y + tools.height || canvas.y + window[1] + window[3] <= tools.y).toBe(true);
    expect(window[0] + window[2]).toBeLessThanOrEqual(canvas.width);
    expect(window[1] + window[3]).toBeLessThanOrEqual(canvas.height);
    for (const tab of ['Settings', 'Timing']) {
      const { x, y } = await inspector.placeOf(tab);
      await page.touchscreen.tap(x, y);
      await inspector.expectState((state) => state.tab, tab);
    }
    const before = await app.centre();
    const { x, y } = await inspector.placeOf('Maps');
    await page.touchscreen.tap(x, y);
    await inspector.expectState((state) => state.tab, 'Maps');
    expect(await app.centre()).toEqual(before); // no tap passed through to the model
  });
});

test('On a phone, a Wi-Fi access is filled in by touch, with nothing wider than the screen', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  await page.getByRole('combobox', { name: 'Kind of content' }).selectOption('Wi-Fi access');
  await page.getByLabel('Network name').fill('net');
  await page.getByLabel('Password', { exact: true }).fill('long enough');
  await page.getByRole('button', { name: 'Show the password' }).tap();
  await expect(page.getByLabel('Password', { exact: true })).toHaveAttribute('type', 'text');
  await expect(app.text).toHaveValue('WIFI:T:WPA;S:net;P:long enough;;');
  await expect(page.getByRole('img', { name: 'QR code, 29 × 29 modules' })).toBeVisible();

  await page.getByRole('combobox', { name: 'Kind of content' }).selectOption('Contact');
  await page.getByLabel('First name').fill('Ada');
  for (const control of await page
    .getByRole('group', { name: 'Contact', exact: true })
    .locator('input, select')
    .all()) {
    const box = await control.boundingBox();
    expect(box?.height).toBeGreaterThanOrEqual(40);
    expect((box?.x ?? 0) + (box?.width ?? 1000)).toBeLessThanOrEqual(360);
  }
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
});

test('On the narrowest phone the legend leaves the code free; sideways the view lies beside the steps', async ({
  page,
}) => {
  await page.setViewportSize({ width: 320, height: 640 });
  const app = new Engraver(page);
  await app.open('?sample=saddle&process=none');
  await app.expectReady();
  const boxOf = async (/** @type {import('@playwright/test').Locator} */ what) =>
    /** @type {{ x: number, y: number, width: number, height: number }} */ (await what.boundingBox());

  await test.step('the narrowest', async () => {
    await app.suggest();
    const legend = await boxOf(page.getByLabel('Colours of the model'));
    const grip = await boxOf(app.moveHandle);
    expect(grip.y + grip.height).toBeLessThanOrEqual(legend.y);
    const [first, second] = await Promise.all([0, 1].map((at) => boxOf(app.spots.nth(at))));
    expect(second.y).toBe(first.y);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
  });

  const sideways = [
    { width: 640, height: 360 },
    { width: 740, height: 360 },
    { width: 932, height: 430 },
  ];
  for (const { width, height } of sideways) {
    await test.step(`sideways, ${width} by ${height}`, async () => {
      await page.setViewportSize({ width, height });
      const stage = width - 320;
      await poll(async () => (await boxOf(app.canvas)).width).toBe(stage);
      await expect(app.engraveButton).toBeInViewport();
      expect((await boxOf(app.canvas)).height).toBe(height - 42); // one row of buttons; what has no room scrolls
      /** @type {Box[]} */ const buttons = [];
      for (const name of ['Construction', 'Plate', 'Section', 'Sizes', 'Views']) {
        const button = page.getByRole('button', { name, exact: true });
        await button.scrollIntoViewIfNeeded();
        const box = await boxOf(button);
        expect(box.x).toBeGreaterThanOrEqual(0);
        expect(Math.round(box.x + box.width)).toBeLessThanOrEqual(stage);
        expect(box.y + box.height).toBeLessThanOrEqual(42);
        buttons.push(box);
      }
      const legend = page.getByLabel('Colours of the model');
      const handles = await Promise.all([app.turnHandle, app.moveHandle, app.sizeHandle].map(boxOf));
      for (const covering of [...buttons, await boxOf(legend)])
        expect(handles.filter((handle) => overlap(handle, covering))).toEqual([]);
      const section = page.getByRole('button', { name: 'Section', exact: true });
      await section.tap();
      const [slider, cube] = await Promise.all([page.locator('#section-bar'), page.locator('.view-cube')].map(boxOf));
      expect(overlap(slider, cube)).toBe(false);
      expect(overlap(slider, await boxOf(legend))).toBe(false);
      await section.tap();
    });
  }
});

/** @typedef {{ x: number, y: number, width: number, height: number }} Box */

/** @param {Box} a @param {Box} b */
const overlap = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/**
 * Moves two fingers around (x, y) from one distance to another.
 * @param {import('@playwright/test').Page} page
 * @param {number} x
 * @param {number} y
 * @param {number} from
 * @param {number} to
 */
async function pinch(page, x, y, from, to) {
  const client = await page.context().newCDPSession(page);
  const fingers = (/** @type {number} */ distance) => [
    { x: x - distance / 2, y, id: 0 },
    { x: x + distance / 2, y, id: 1 },
  ];
  await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: fingers(from) });
  for (let step = 1; step <= 5; step += 1) {
    const touchPoints = fingers(from + ((to - from) * step) / 5);
    await client.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints });
  }
  await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await client.detach();
}
