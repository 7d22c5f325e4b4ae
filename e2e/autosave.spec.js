// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { untilKept } from './support/kept.js';
import { saddleFile, truncatedFile } from './support/models.js';
import { poll } from './support/poll.js';

test('Work is offered and restored after a reload, but not if nothing changed or it was discarded', async ({
  page,
}) => {
  const app = new Engraver(page);
  const offer = page.getByText(/^Continue with .*\?$/);
  await app.open();
  await app.expectReady();

  await test.step('a page without changes', async () => {
    await page.reload();
    await app.expectReady();
    await expect(offer).toHaveCount(0);
  });

  await test.step('discarded', async () => {
    await app.text.fill('WIFI:T:WPA;S:home;P:very secret;;');
    await app.sample.selectOption('Star');
    await untilKept(page, (work) => work?.sampleId === 'star' && !JSON.stringify(work).includes('secret'));
    await page.reload();
    await expect(offer).toHaveText('Continue with Star?');
    await app.expectReady();
    await app.file.setInputFiles(truncatedFile);
    await expect(app.alert).toBeVisible();
    for (const size of [
      { width: 1024, height: 640 },
      { width: 740, height: 360 },
      { width: 360, height: 740 },
    ]) {
      await page.setViewportSize(size);
      const [error, notice] = await Promise.all(
        [page.locator('#alert'), page.locator('.notice')].map((one) => one.boundingBox()),
      );
      if (!error || !notice) throw new Error('An error or the offer has no size');
      expect(notice.y + notice.height).toBeLessThanOrEqual(error.y); // neither covers the other
    }
    await page.setViewportSize({ width: 360, height: 640 }); // no room for both
    await expect(offer).toBeHidden();
    await page.getByRole('button', { name: 'Dismiss' }).click();
    await expect(offer).toBeVisible();
    await page.setViewportSize({ width: 1024, height: 640 });
    await page.getByRole('button', { name: 'Discard' }).click();
    await expect(offer).toHaveCount(0);
    await untilKept(page, (work) => work === undefined);
    await page.reload();
    await app.expectReady();
    await expect(offer).toHaveCount(0);
  });

  await test.step('the model, its unit, the text, the settings and the centre', async () => {
    await app.file.setInputFiles(saddleFile);
    await expect(app.facts).toContainText('my saddle.stl');
    await app.expectReady();
    await app.openSettings();
    await app.setting('Unit').selectOption('inch');
    await expect(app.facts).toContainText('2,286.0 × 2,286.0 × 1,016.0 mm');
    await app.expectReady();
    await app.text.fill('to be continued');
    await app.setting('Rotation (°)').fill('15');
    await app.setting('Rotation (°)').blur();
    await app.expectReady();
    const box = /** @type {{ width: number, height: number }} */ (await app.canvas.boundingBox());
    const proposed = await app.centre();
    await app.canvas.click({ position: { x: box.width / 2 + 30, y: box.height / 2 } });
    await poll(() => app.centre()).not.toEqual(proposed);
    await app.expectReady();
    const centre = await app.centre();
    await untilKept(
      page,
      (work) =>
        work?.text === 'to be continued' &&
        work.settings.rotateDeg === 15 &&
        work.centreMm?.every(
          (/** @type {number} */ v, /** @type {number} */ axis) => Math.abs(v - centre[axis]) < 0.01,
        ),
    );

    await page.reload();
    await app.expectReady();
    await expect(app.facts).not.toContainText('my saddle.stl');
    await expect(offer).toHaveText('Continue with my saddle.stl?');
    await page.getByRole('button', { name: 'Continue' }).click();
    await expect(offer).toHaveCount(0);
    await expect(app.facts).toHaveText('my saddle.stl, 2,286.0 × 2,286.0 × 1,016.0 mm');
    await app.expectReady();
    await expect(app.text).toHaveValue('to be continued');
    await expect(app.setting('Rotation (°)')).toHaveValue('15');
    (await app.centre()).forEach((v, axis) => expect(v).toBeCloseTo(centre[axis], 1));
  });
});
