// SPDX-License-Identifier: GPL-3.0-or-later
// A label: text under the code and a frame round it, shown before anything is engraved.
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { lookRound } from './support/code_in_picture.js';
import { poll } from './support/poll.js';

const kFrame = 5; // modules from the symbol to the middle of the frame's line
const kQuiet = 2; // to the middle of the quiet zone

test('The label is shown on the model while it is typed, for every way to make the code', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=plate&text=A');
  await app.expectReady();
  await app.openSettings();
  await page.getByRole('button', { name: 'Phone view' }).click();
  /** Returns which places beside and above the code are dark. @param {number} away  modules from the symbol */
  const darkAt = async (away) => {
    const code = await lookRound(app.canvas);
    return code && ['left', 'above', 'right'].map((side) => code.isDark(side, away));
  };
  /** Returns how much of the line under the quiet zone is dark. */
  const inkInText = async () => (await lookRound(app.canvas))?.darkShare(4.5, 7.2) ?? NaN;

  await test.step('without a label, there is no frame', async () => {
    await poll(() => darkAt(kFrame)).toEqual([false, false, false]);
  });

  for (const mark of ['Shadow', 'Second colour, inlaid', 'Second colour, painted']) {
    await test.step(`${mark}: frame and text follow the fields`, async () => {
      await app.setting('Made by').selectOption(mark);
      await app.setting('Label').fill('HHHHHH');
      await poll(inkInText).toBeGreaterThan(0.2);
      await app.setting('Label').fill('I');
      await expect(async () => {
        const ink = await inkInText();
        expect(ink).toBeLessThan(0.1);
        expect(ink).toBeGreaterThan(0.015);
      }).toPass({ timeout: 120_000 });
      await app.setting('Frame').selectOption('Rounded corners');
      await poll(() => darkAt(kFrame)).toEqual([true, true, true]);
      await poll(() => darkAt(kQuiet)).toEqual([false, false, false]);
      await app.setting('Label').fill('');
      await app.setting('Frame').selectOption('None');
      await poll(() => darkAt(kFrame)).toEqual([false, false, false]);
    });
  }
});
