// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { wavySphereStl } from './support/big_model.js';
import { Engraver } from './support/engraver.js';
import { freeze, holdWorkers } from './support/workers.js';

/** @typedef {import('@playwright/test').Page} Page */

const kCancelled = 'Cancelled. The model is unchanged.';

/**
 * Clicks Cancel in the page as soon as the status shows the stage. From then on nothing reaches the worker until the
 * status says that the work was cancelled and the Cancel button is gone. So the page itself must obey, whatever the
 * worker does.
 * @param {Page} page
 * @param {string} stage  beginning of the status
 * @param {string} [cancelled]  final status
 * @returns {Promise<number | undefined>}  ms from the click to the final status, by the page's own clock; none: the page
 *   was too busy to show the stage before the work ended
 */
const cancelAt = (page, stage, cancelled = kCancelled) =>
  page.evaluate(
    ([begin, end]) =>
      new Promise((resolve) => {
        const status = /** @type {HTMLElement} */ (document.querySelector('[role="status"]'));
        const button = /** @type {HTMLElement} */ (document.getElementById('cancel'));
        const { freeze: hold, thaw } = /** @type {any} */ (window);
        let clicked = 0;
        const look = () => {
          const words = status.textContent ?? '';
          if (clicked === 0 && words.startsWith(begin) && button.offsetParent !== null) {
            clicked = performance.now();
            hold();
            button.click();
          } else if (clicked > 0 && words === end && button.offsetParent === null) {
            observer.disconnect();
            resolve(performance.now() - clicked);
            thaw();
          } else if (clicked === 0 && words.startsWith('Engraved')) {
            observer.disconnect();
            resolve(undefined);
          }
        };
        const observer = new MutationObserver(look);
        observer.observe(document.body, { childList: true, characterData: true, attributes: true, subtree: true });
        look();
      }),
    [stage, cancelled],
  );

const kStages = [
  'Preparing',
  'Measuring the surface',
  'Finding the depth',
  'Engraving the mesh',
  'Checking the solid',
  'Checking the result',
];

test('Cancelling works at once in every stage and loses nothing', async ({ page }) => {
  const app = new Engraver(page);
  await page.addInitScript(holdWorkers);
  const begin = async () => {
    await app.open('?sample=saddle&text=cancelled%20often');
    await page.evaluate(() => {
      /** @type {any} */ (window).skipped = ['prepareEngrave']; // otherwise the page prepares the carving in advance
    });
    await app.expectReady();
  };
  await begin();
  const centre = await app.centre();
  /** @type {string[]} */ const measured = [];
  const expectCancelled = async (/** @type {string} */ stage, /** @type {Promise<number | undefined>} */ time) => {
    const ms = await time;
    expect(ms, `“${stage}” was shown`).toBeDefined();
    measured.push(`${stage} ${ms?.toFixed(0)} ms`);
    await expect(app.progress).toBeHidden();
    await expect(app.result).toBeHidden();
    await expect(app.engraveButton).toBeEnabled();
  };

  for (const stage of kStages) {
    await test.step(stage, async () => {
      const cancelledEngraving = async () => {
        const time = cancelAt(page, stage);
        await app.engraveButton.click();
        return time;
      };
      let time = await cancelledEngraving();
      for (let tries = 1; time === undefined && tries < 4; tries += 1) {
        await begin();
        time = await cancelledEngraving();
      }
      await expectCancelled(stage, Promise.resolve(time));
    });
  }
  await expect(app.status).toHaveText(kCancelled);

  await test.step('while the code is being placed', async () => {
    await freeze(page);
    await app.text.fill('cancelled at last');
    await app.engraveButton.click();
    await expect(app.progress).toBeVisible();
    await expect(app.progress).toHaveAccessibleName(/\S/);
    await expectCancelled('placing', cancelAt(page, 'Preparing'));
    await app.expectReady();
  });

  await test.step('the search for spots', async () => {
    const time = cancelAt(page, 'Looking for spots', 'Cancelled.');
    await page.getByRole('button', { name: 'Suggest spots' }).click();
    await expectCancelled('spots', time);
    await expect(app.spots).toHaveCount(0);
    await app.suggest();
    await expect(app.spots).not.toHaveCount(0);
  });

  await test.step('while reading a file: the previous model stays', async () => {
    const time = cancelAt(page, 'Reading big.stl');
    await app.file.setInputFiles({ name: 'big.stl', mimeType: 'model/stl', buffer: wavySphereStl(200) });
    await expectCancelled('reading', time);
    await app.expectReady();
    await expect(app.facts).toContainText('90.0 × 90.0 × 40.0 mm');
  });

  console.log(`cancel: ${measured.join(', ')}`);
  expect(await app.centre()).toEqual(centre);
  await app.engrave();
  await expect(app.result).toContainText('Reads as cancelled at last');
});
