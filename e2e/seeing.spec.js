// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { isOrange, isTeal, isViolet, shareOf } from './support/pixels.js';
import { poll } from './support/poll.js';

test.use({ viewport: { width: 1280, height: 800 } }); // the limits for colours assume this size

test('The view shows every side, a section, the carving, and the phone’s view', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=HELLO&process=none');
  await app.expectReady();

  const reader = page.getByRole('button', { name: 'Phone view' });
  const view = page.getByRole('group', { name: 'Phone view' });
  await test.step('from the phone, before engraving', async () => {
    await reader.click();
    await expect(view).toContainText('Not engraved yet');
    await expect(app.moveHandle).toBeHidden();
    await page.getByRole('button', { name: 'Fit' }).click();
    await expect(view).toBeHidden();
    await expect(app.moveHandle).toBeVisible();
  });

  await test.step('a new model is not seen from the phone', async () => {
    await reader.click();
    await expect(view).toBeVisible();
    await app.sample.selectOption('Vase');
    await expect(view).toBeHidden();
    await app.expectReady();
    await expect(view).toBeHidden();
    await app.sample.selectOption('Saddle');
    await app.expectReady();
  });

  await test.step('a section opens the model across the code, and its position can be moved', async () => {
    const section = page.getByRole('button', { name: 'Section' });
    const position = page.getByRole('slider', { name: 'Position of the section' });
    await poll(() => shareOf(app.canvas, isOrange)).toBeLessThan(0.001);
    await section.click();
    await expect(position).toBeVisible();
    await poll(() => shareOf(app.canvas, isOrange)).toBeGreaterThan(0.01);
    await position.fill('0.9');
    await position.press('ArrowLeft');
    await poll(() => shareOf(app.canvas, isOrange)).toBeGreaterThan(0.002);
    await section.click();
    await expect(position).toBeHidden();
    await poll(() => shareOf(app.canvas, isOrange)).toBeLessThan(0.001);
  });

  await test.step('by menu, by keys and by the cube', async () => {
    const faces = page.locator('.view-cube [data-view]');
    // The visible faces. There may be more while the cube turns.
    const seen = () => faces.evaluateAll((all) => all.map((face) => face.getAttribute('data-view')));
    const views = page.getByRole('button', { name: 'Views' });
    await views.click();
    await page.getByRole('group', { name: 'Views' }).getByRole('button', { name: 'Top' }).click();
    await expect(views).toHaveAttribute('aria-expanded', 'false');
    await poll(seen).toEqual(['top']);

    await app.canvas.focus();
    for (const [key, name] of [
      ['1', 'front'],
      ['2', 'back'],
      ['3', 'left'],
      ['4', 'right'],
      ['6', 'bottom'],
    ]) {
      await page.keyboard.press(key);
      await poll(seen).toEqual([name]);
    }
    await page.keyboard.press('7');
    await expect(faces).toHaveCount(3);
    await page.locator('.view-cube [data-view="right"]').click();
    await poll(seen).toEqual(['right']);
  });

  await test.step('the phone’s view', async () => {
    await app.engrave();
    await expect(app.moveHandle).toBeHidden();
    await reader.click();
    await expect(view).toContainText('The phone reads: HELLO');
  });

  await test.step('the depths in mm, and the uncarved model', async () => {
    const legend = page.getByLabel('Colours of the model');
    await poll(() => shareOf(app.canvas, isTeal)).toBeLessThan(0.03);
    await page.getByRole('button', { name: 'Depths' }).click();
    await expect(legend).toContainText(/Depth of the engraving\s*0\smm\s*[\d.]+\smm\s*≥ [\d.]+\smm/);
    await poll(() => shareOf(app.canvas, isTeal)).toBeGreaterThan(0.035);
    const { depth } = await app.report();
    const top = Number(/≥ ([\d.]+)\smm$/.exec((await legend.innerText()).trim())?.[1]);
    expect(top).toBeGreaterThanOrEqual(depth.p95Mm - 1e-3);
    expect(top).toBeLessThan(depth.p95Mm + 0.1);

    const before = page.getByRole('button', { name: 'Before' });
    await before.focus();
    await page.keyboard.down('Space');
    await expect(before).toHaveAttribute('aria-pressed', 'true');
    await poll(() => shareOf(app.canvas, isTeal)).toBeLessThan(0.03);
    await page.keyboard.up('Space');
    await poll(() => shareOf(app.canvas, isTeal)).toBeGreaterThan(0.035);
    await page.getByRole('button', { name: 'With code' }).click();
    await expect(legend).toBeHidden();
    await expect(before).toBeHidden();
  });
});

test('The construction shows how the code was placed, also after a move and after carving', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=bumpy-sphere&text=HELLO&process=none');
  await app.expectReady();
  const button = page.getByRole('button', { name: 'Construction' });
  const legend = page.locator('.construction-legend');
  const closestMm = async () => Number(/S, its point closest to C: ([\d.]+)\smm/.exec(await legend.innerText())?.[1]);
  await poll(() => shareOf(app.canvas, isViolet)).toBeLessThan(0.0005);

  await button.click();
  await expect(legend).toContainText('Central projection from the eye, 250 mm away');
  await poll(() => shareOf(app.canvas, isViolet)).toBeGreaterThan(0.002);
  const first = await closestMm();
  expect(first).toBeGreaterThan(20);
  await expect(page.locator('.construction-names')).toContainText(/C.*S/);

  await app.openSettings();
  await app.setting('Viewing distance (mm)').fill('120'); // the nearer the eye, the smaller the silhouette
  await app.setting('Viewing distance (mm)').blur();
  await expect(legend).toContainText('120 mm away');
  await poll(closestMm).toBeLessThan(first);

  await app.engrave();
  await expect(legend).toContainText('120 mm away');
  await button.click();
  await expect(legend).toBeHidden();
  await poll(() => shareOf(app.canvas, isViolet)).toBeLessThan(0.0005);
});

test('The lamps light the model, and dragging one moves it round the code', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=bumpy-sphere&text=HELLO&process=none&light=0,20,9');
  await app.expectReady();
  const button = page.getByRole('button', { name: 'Lamp light' });
  await expect(button).toHaveAttribute('aria-pressed', 'true');
  const sun = page.locator('.lamp-marks .hold');
  const middle = async () => {
    const { x, y, width, height } = /** @type {{ x: number, y: number, width: number, height: number }} */ (
      await sun.boundingBox()
    );
    return { x: x + width / 2, y: y + height / 2 };
  };
  const drag = async () => {
    const from = await middle();
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x - 40, from.y - 30, { steps: 4 });
    await poll(async () => (await middle()).x).toBeLessThan(from.x - 20);
    return from;
  };
  const azimuth = page.locator('#lamp-1-azimuthDeg');
  const elevation = page.locator('#lamp-1-elevationDeg');

  await test.step('by a switch', async () => {
    const live = page.getByRole('button', { name: 'As carved' });
    await live.click(); // or the code changes once its depths are found
    const lit = await app.settledPicture();
    await button.click();
    await poll(() => app.differenceFrom(lit)).toBeGreaterThan(0.004);
    await button.click();
    await poll(() => app.differenceFrom(lit)).toBeLessThan(0.002);
    await live.click();
  });

  await test.step('while it is dragged, and as a setting afterwards', async () => {
    const from = await drag();
    await expect(azimuth).toHaveValue('0');
    await page.mouse.up();
    await poll(() => azimuth.inputValue()).not.toBe('0');
    expect(Number(await elevation.inputValue())).toBeGreaterThan(20);
    await app.expectReady();
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect(azimuth).toHaveValue('0');
    await expect(elevation).toHaveValue('20');
    await app.expectReady();
    await poll(async () => Math.abs((await middle()).x - from.x)).toBeLessThan(2);
  });

  await test.step('until Escape', async () => {
    const from = await drag();
    await page.keyboard.press('Escape');
    await poll(async () => Math.abs((await middle()).x - from.x)).toBeLessThan(2);
    await page.mouse.up();
    await expect(azimuth).toHaveValue('0');
  });
});
