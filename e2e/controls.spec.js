// SPDX-License-Identifier: GPL-3.0-or-later
// Every control of the page has an effect, whether pressed with a mouse on a desktop or with a finger on a phone. Other
// specs check the full effect of each control; this one leaves out none. A phone tries those that are pressed: the others
// are the same on both.
import { expect, test } from '@playwright/test';
import { kOfTheParts } from './support/batch_controls.js';
import { kOfTheCarving } from './support/carving_controls.js';
import { openWithHands, settingsFile } from './support/hands.js';
import { kOfTheModel } from './support/model_controls.js';
import { kOfThePage, kOfTheView } from './support/page_controls.js';
import { kOfThePlace } from './support/place_controls.js';
import { kSettings } from './support/setting_controls.js';
import { kTestedControls } from './support/tested_controls.js';

/** @typedef {import('./support/hands.js').Hands} Hands */
/** @typedef {import('./support/hands.js').Effects} Effects */

const isPhone = () => test.info().project.name === 'phone';

/** Controls that are pressed or dragged, not typed into or chosen from. */
const kPressed = 'button, [type="checkbox"], [type="radio"], [type="range"], [type="file"]';

/** @param {Hands} hands @param {Effects[]} parts */
async function tryAll(hands, ...parts) {
  for (const [id, effect] of parts.flatMap((effects) => Object.entries(effects)))
    if (!isPhone() || (await hands.at(id).and(hands.page.locator(kPressed)).count()) > 0)
      await test.step(id, () => effect(hands));
}

test('Every control before the carving has its effect, and the test covers all', async ({ page }) => {
  const hands = await openWithHands(page);
  await tryAll(hands, kOfTheModel, kOfTheParts, kOfThePlace, kOfTheView, kOfThePage);

  const all = await page.evaluate(() =>
    [...document.querySelectorAll('button, input, select, textarea')]
      .filter((control) => control.getAttribute('type') !== 'hidden' && (control.id || control.closest('.views-menu')))
      .map((control) => control.id || String(control.getAttribute('data-view'))),
  );
  expect(all.filter((id) => !kTestedControls.includes(id))).toEqual([]);
  expect(kTestedControls.filter((id) => !all.includes(id))).toEqual([]);
});

test('Every setting is saved and carved with, and every control of the carving has its effect', async ({ page }) => {
  const hands = await openWithHands(page);
  const { app, at, press } = hands;
  const settings = Object.entries(kSettings).filter(([, { value }]) => !isPhone() || typeof value === 'boolean');
  let before = (await settingsFile(app)).settings;
  for (const [id, setting] of settings) {
    await test.step(id, async () => {
      const control = at(id);
      if (typeof setting.value === 'boolean') await press(id);
      else if (await control.evaluate((element) => element.tagName === 'SELECT'))
        await control.selectOption(setting.value);
      else await control.fill(setting.value);
      await control.blur();
      const after = (await settingsFile(app)).settings;
      expect(after).not.toEqual(before);
      expect(after).toMatchObject(setting.saved);
      before = after;
    });
  }
  await app.expectReady();
  const { cancel, 'engrave-again': again, 'another-code': another, ...others } = kOfTheCarving;
  await tryAll(hands, others);
  const report = await app.report();
  for (const [id, { saved, reported }] of settings)
    if (reported) expect(reported(report), id).toBe(Object.values(saved)[0]);
  await tryAll(hands, { 'engrave-again': again, cancel, 'another-code': another });
});
