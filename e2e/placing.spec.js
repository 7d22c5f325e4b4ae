// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { findCode } from './support/decode.js';
import { Engraver } from './support/engraver.js';
import { meanDifference } from './support/pixels.js';
import { poll } from './support/poll.js';
import { readPng } from './support/read_png.js';

/** @typedef {[number, number]} Point */

/**
 * Returns the middle of a handle at rest, in page pixels: handles follow the code with the next frame.
 * @param {import('@playwright/test').Locator} handle
 * @returns {Promise<Point>}
 */
async function middleOf(handle) {
  await expect(handle).toBeVisible();
  const boxNow = async () =>
    /** @type {{ x: number, y: number, width: number, height: number }} */ (await handle.boundingBox());
  let box = await boxNow();
  await poll(async () => {
    const before = box;
    await handle.page().waitForTimeout(200);
    box = await boxNow();
    return [box.x - before.x, box.y - before.y];
  }).toEqual([0, 0]);
  return [box.x + box.width / 2, box.y + box.height / 2];
}

/** @param {import('@playwright/test').Page} page @param {Point} from @param {Point[]} through */
async function drag(page, from, through) {
  await page.mouse.move(...from);
  await page.mouse.down();
  for (const point of through) await page.mouse.move(...point, { steps: 3 });
}

test('The code follows the pointer in its size, exactly once it rests, and a click places it', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=bumpy-sphere');
  await app.expectReady();
  const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await app.canvas.boundingBox());

  await app.showLive();
  await test.step('the pointer', async () => {
    const before = await app.centre();
    await page.mouse.move(box.x + 0.63 * box.width, box.y + 0.49 * box.height);
    await page.mouse.move(box.x + 0.64 * box.width, box.y + 0.5 * box.height);
    await expect(app.chip).toContainText(/mm wide\s*modules of\s[\d.]+\smm/);
    await expect(app.chip).toHaveAttribute('data-exact', 'true');
    await expect(app.chip).toContainText(/[\d.]+\smm deep, [\d.]+\smm at most/); // it is shown as it will be carved
    const promised = Number(/^([\d.]+)\smm wide/.exec(await app.chip.innerText())?.[1]);
    expect(promised).toBeGreaterThan(3);
    expect(await app.centre()).toEqual(before);

    await page.mouse.down();
    await page.mouse.up();
    await poll(() => app.centre()).not.toEqual(before);
    await app.expectReady();
    expect(await app.width()).toBeCloseTo(promised, 1);
    await page.mouse.move(5, 700); // next to the model
    await expect(app.chip).toBeHidden();
  });

  await test.step('the grip moves the code', async () => {
    const before = await app.centre();
    const from = await middleOf(app.moveHandle);
    await drag(page, from, [
      [from[0] + 30, from[1] - 20],
      [from[0] + 45, from[1] - 25],
    ]);
    await expect(app.chip).toContainText('mm wide');
    await page.mouse.up();
    await poll(() => app.centre()).not.toEqual(before);
    await app.expectReady();
    await poll(async () => {
      const after = await middleOf(app.moveHandle);
      return Math.hypot(after[0] - from[0] - 45, after[1] - from[1] + 25);
    }).toBeLessThan(6); // the handles follow with the next frame
  });

  await test.step('a drag turns the model but keeps the centre; a click then hits elsewhere on the sphere', async () => {
    const before = await app.centre();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x - 120, y - 120); // clear of the code's handles
    await page.mouse.down();
    await page.mouse.move(x - 60, y - 100, { steps: 6 });
    await page.mouse.up();
    expect(await app.centre()).toEqual(before);

    await page.mouse.click(x - 60, y - 60);
    await poll(() => app.centre()).not.toEqual(before);
    await app.expectReady();
    const [cx, cy, cz] = await app.centre();
    expect(Math.abs(Math.hypot(cx, cy, cz - 50) - 48)).toBeLessThan(2.6); // on the bumpy sphere
  });

  await test.step('the keyboard alone turns the model and places, moves, turns and resizes the code', async () => {
    let before = await app.centre();
    await app.canvas.focus();
    for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowLeft', '+', 'Enter']) await page.keyboard.press(key);
    await poll(() => app.centre()).not.toEqual(before);
    await app.expectReady();

    before = await app.centre();
    await expect(app.moveHandle).toBeVisible(); // the handle appears with the next frame
    await page.keyboard.press('Tab');
    await expect(app.moveHandle).toBeFocused();
    for (const key of ['ArrowRight', 'ArrowRight', 'ArrowUp', 'Enter']) await page.keyboard.press(key);
    await poll(() => app.centre()).not.toEqual(before);
    await app.expectReady();

    await expect(app.turnHandle).toBeVisible();
    await page.keyboard.press('Tab');
    await expect(app.turnHandle).toBeFocused();
    for (const key of ['PageUp', 'ArrowRight', 'Enter']) await page.keyboard.press(key);
    await poll(() => app.rotation()).toBe(16);
    await app.expectReady();
    await page.keyboard.press('Home');
    await page.keyboard.press('Enter');
    await poll(() => app.rotation()).toBe(0);
    await app.expectReady();

    const width = await app.width();
    await expect(app.sizeHandle).toBeVisible();
    await page.keyboard.press('Tab');
    await expect(app.sizeHandle).toBeFocused();
    for (const key of ['PageDown', 'Enter']) await page.keyboard.press(key);
    await poll(() => app.width()).toBeLessThan(width - 6);
  });

  await test.step('Shift and the wheel turn the code in steps of five degrees', async () => {
    await page.mouse.move(box.x + 120, box.y + 400);
    await page.keyboard.down('Shift');
    for (let notch = 0; notch < 3; notch += 1) await page.mouse.wheel(0, -100);
    await page.keyboard.up('Shift');
    await poll(() => app.rotation()).toBe(15);
  });
});

test('The turning handle turns the code and snaps near upright, and a button sets it upright', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  const middle = await middleOf(app.moveHandle);
  const handle = await middleOf(app.turnHandle);
  const [dx, dy] = [handle[0] - middle[0], handle[1] - middle[1]];
  await drag(page, handle, [[middle[0] + dx * 0.8 + dy * 0.6, middle[1] + dy * 0.8 - dx * 0.6]]);
  await expect(app.chip).toContainText('mm wide');
  await page.mouse.up();
  await poll(async () => Math.abs(await app.rotation())).toBeGreaterThan(15);
  await app.expectReady();
  const turned = await app.rotation();
  await expect(app.turnHandle).toHaveAttribute('aria-valuenow', String(turned));
  await page.getByRole('button', { name: 'Upright' }).click();
  await poll(() => app.rotation()).toBe(0);
  await app.expectReady();

  const awayFromUpright = async () => Math.abs((await middleOf(app.turnHandle))[0] - handle[0]);
  await poll(awayFromUpright).toBeLessThan(2); // the handles follow with the next frame
  const again = await middleOf(app.turnHandle);
  await drag(page, again, [[again[0] + 3, again[1]]]);
  await page.mouse.up();
  expect(await app.rotation()).toBe(0);
});

test('The corner handle resizes the code, stops where it no longer fits, and Escape reverts it', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  const before = await app.width();
  const middle = await middleOf(app.moveHandle);
  const corner = await middleOf(app.sizeHandle);
  /** @param {number} factor @returns {Point} */
  const at = (factor) => [middle[0] + (corner[0] - middle[0]) * factor, middle[1] + (corner[1] - middle[1]) * factor];
  await drag(page, corner, [at(2.2)]);
  await expect(app.chip).toContainText('mm wide');
  await expect(app.chip).not.toContainText('overhangs');
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await app.expectReady();
  expect(await app.width()).toBe(before);

  const fromCorner = async () => Math.abs((await middleOf(app.sizeHandle))[0] - corner[0]);
  await poll(fromCorner).toBeLessThan(2); // the handles follow with the next frame
  await drag(page, corner, [at(1.7), at(2.2)]);
  await expect(app.chip).toContainText('mm wide');
  await page.mouse.up();
  await app.expectReady();
  expect(await app.width()).toBeGreaterThanOrEqual(0.95 * before);
  await page.getByRole('button', { name: 'Undo' }).click();
  await app.expectReady();
  await poll(() => app.width()).toBe(before);

  await poll(fromCorner).toBeLessThan(2);
  await drag(page, corner, [at(0.6)]);
  await page.mouse.up();
  await expect(app.setting('Size of the code')).toHaveValue('fixed');
  await poll(() => app.width()).toBeLessThan(0.75 * before);
  await app.expectReady();
  expect(Number(await app.setting('Width (mm)').inputValue())).toBe(await app.width());
});

test('Each drag of a handle is undone and redone separately', async ({ page }) => {
  const app = new Engraver(page);
  const undo = page.getByRole('button', { name: 'Undo' });
  const redo = page.getByRole('button', { name: 'Redo' });
  await app.open('?sample=saddle');
  await app.expectReady();
  const state = async () => ({ width: await app.width(), rotation: await app.rotation(), centre: await app.centre() });
  const states = [await state()];
  const middle = await middleOf(app.moveHandle);
  const drags = [
    {
      handle: app.sizeHandle,
      by: (/** @type {Point} */ [x, y]) =>
        /** @type {Point} */ ([x + (middle[0] - x) * 0.3, y + (middle[1] - y) * 0.3]),
    },
    { handle: app.turnHandle, by: (/** @type {Point} */ [x, y]) => /** @type {Point} */ ([x + 60, y + 30]) },
    { handle: app.moveHandle, by: (/** @type {Point} */ [x, y]) => /** @type {Point} */ ([x + 25, y + 15]) },
  ];
  for (const { handle, by } of drags) {
    const from = await middleOf(handle);
    await drag(page, from, [by(from)]);
    await page.mouse.up();
    await poll(state).not.toEqual(states.at(-1));
    await app.expectReady();
    states.push(await state());
  }
  for (let i = states.length - 2; i >= 0; i -= 1) {
    await undo.click();
    await poll(state).toEqual(states[i]);
    await app.expectReady();
  }
  await expect(undo).toBeDisabled();
  for (const after of states.slice(1)) {
    await expect(redo).toBeEnabled();
    await redo.click();
    await poll(state).toEqual(after);
    await app.expectReady();
  }
  await expect(redo).toBeDisabled();
});

test('A placed code is shown as it will be carved, and looks alike once it is', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=plate&text=QRelief');
  await app.expectReady();
  await page.getByRole('button', { name: 'Views' }).click();
  await page.getByRole('group', { name: 'Views' }).getByRole('button', { name: 'Top' }).click();
  await app.showLive();
  await page.locator('.code-handles').evaluate((handles) => {
    handles.style.visibility = 'hidden';
  });
  const before = await app.settledPicture();
  const code = await findCode(before);
  expect(code).toBeDefined();
  await app.engrave();
  const after = await app.settledPicture();
  const { topLeft, bottomRight } = /** @type {NonNullable<typeof code>} */ (code).position;
  const module = Math.round((bottomRight.x - topLeft.x) / 21);
  expect(meanDifference(readPng(before), readPng(after), topLeft, bottomRight, module)).toBeLessThan(0.02);
});
