// SPDX-License-Identifier: GPL-3.0-or-later
// Effects of the controls of the model, for controls.spec.js.
import { expect } from '@playwright/test';
import { settingsFile } from './hands.js';
import { saddleFile, truncatedFile } from './models.js';

/** @type {import('./hands.js').Effects} */
export const kOfTheModel = {
  file: async ({ app, at }) => {
    await at('file').setInputFiles(saddleFile);
    await expect(app.facts).toContainText('my saddle.stl');
    await app.expectReady();
  },
  unit: async ({ app, at }) => {
    const before = await app.facts.innerText();
    await at('unit').selectOption('cm');
    await expect(app.facts).not.toHaveText(before);
    await at('unit').selectOption('mm');
    await expect(app.facts).toHaveText(before);
    await app.expectReady();
  },
  height: async ({ app, at }) => {
    const before = await app.facts.innerText(),
      height = await at('height').inputValue();
    await at('height').fill(String(2 * Number(height)));
    await at('height').press('Tab');
    await expect(at('unit')).toHaveValue('2');
    await expect(app.facts).not.toHaveText(before);
    await at('height').fill('-3');
    await at('height').press('Tab');
    await expect(at('height')).toHaveValue(String(2 * Number(height)));
    await at('unit').selectOption('1');
    await expect(app.facts).toHaveText(before);
    await app.expectReady();
  },
  'up-axis': async ({ app, at }) => {
    await at('up-axis').selectOption('y');
    await app.expectReady();
    expect((await settingsFile(app)).model.upAxis).toBe('y');
  },
  'alert-dismiss': async ({ app, at, press }) => {
    await at('file').setInputFiles(truncatedFile);
    await expect(app.alert).toContainText('is cut off');
    await press('alert-dismiss');
    await expect(app.alert).toBeHidden();
  },
  sample: async ({ app, at }) => {
    await at('sample').selectOption('bumpy-sphere');
    await expect(app.facts).toContainText('Bumpy sphere');
    await app.expectReady();
  },
};
