// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, test } from 'node:test';
import { kSettings } from '../generated/settings.js';
import { setLanguage } from './catalogue.js';
import { choiceLabel, controlLabel, controlName, numberName, settingTexts, valueName } from './setting_names.js';
import { isKnownSetting } from './setting_words.js';

after(() => setLanguage('en'));

test('a control is named as in the table, with its unit', async () => {
  await setLanguage('en');
  assert.equal(controlName('minWallMm'), 'Minimum wall (mm)');
  assert.equal(controlName('rotateDeg'), 'Rotation (°)');
  assert.equal(controlName('contrast'), 'Contrast');
  assert.equal(controlName('size'), 'Size of the code');
  assert.equal(numberName('size'), 'Width (mm)');
  assert.equal(controlName('centreMm'), 'Centre on the surface (mm)');
  assert.equal(controlLabel('minWallMm'), 'Minimum wall');
  assert.equal(controlLabel('centreMm'), 'Centre on the surface');
  assert.equal(controlName('colour'), 'colour');
  assert.ok(isKnownSetting('size') && !isKnownSetting('colour'));
});

test('a value is named as its control shows it', async () => {
  await setLanguage('en');
  assert.equal(valueName('mark', 'paint'), choiceLabel('mark', 'paint'));
  assert.equal(valueName('mask', 3), `${controlName('mask')} 3`);
  assert.equal(valueName('minWallMm', 1.25), '1.25');
  assert.equal(valueName('contrast', undefined), 'auto');
  assert.equal(valueName('buildUp', [0, 0, -1]), '−Z up');
  assert.equal(valueName('buildUp', [0, -0.6, 0.8]), 'Chosen face down');
  assert.equal(valueName('up', undefined), 'Up axis of the model');
  assert.equal(valueName('up', [0, -2, 0]), '−Y');
  assert.equal(valueName('up', [0, 0.6, 0.8]), '(0, 0.6, 0.8)');
  assert.equal(valueName('light', [{ azimuthDeg: 45, elevationDeg: 60, strength: 1 }]), '45,60,1');
  assert.equal(valueName('light', undefined), 'Even light');
});

test('choices have names in the chosen language', async () => {
  await setLanguage('de');
  assert.equal(choiceLabel('pattern', 'thick-plus'), 'Dickes Plus');
  assert.equal(choiceLabel('units', 'in'), 'Zoll');
  assert.equal(choiceLabel('pattern', 'dots'), 'dots');
  assert.equal(controlName('minWallMm'), 'Restwand (mm)');
});

test('the module gets every label, choice and group', async () => {
  await setLanguage('de');
  const texts = settingTexts();
  assert.equal(texts['setting:light.2.azimuthDeg'], 'Lampe 2, Azimut');
  assert.equal(texts['setting:size.number'], 'Breite');
  assert.equal(texts['choice:solver:fast'], 'Schnell');
  assert.equal(texts['group:placement'], 'Lage');
  assert.equal(texts['unit:skies'], 'Himmel');
  for (const [key, { choices = [], group }] of Object.entries(kSettings)) {
    assert.ok(texts[`setting:${key}`], key);
    assert.ok(texts[`group:${group}`], group);
    for (const choice of choices) assert.ok(texts[`choice:${key}:${choice}`], choice);
  }
});

test('the labels in the HTML equal those that the script writes', async () => {
  await setLanguage('en');
  const page = readFileSync(new URL('../index.html', import.meta.url), 'utf8');
  const controls = [...page.matchAll(/<(?:input|select) id="([^"]+)" data-setting="([^"]+)"/g)];
  assert.equal(controls.length, page.split('data-setting=').length - 1);
  for (const [, id, key] of controls) {
    assert.ok(key in kSettings, key);
    if (new RegExp(`data-setting="${key}" type="hidden"`).test(page)) continue; // has its own controls
    const setting = /** @type {import('../generated/settings.js').SettingKey} */ (key);
    const said =
      kSettings[setting].kind === 'switch'
        ? new RegExp(`data-setting="${key}"[^>]*>\\s*<span>([^<]*)<`).exec(page)
        : new RegExp(`<label for="${id}"[^>]*>([^<]*)<`).exec(page);
    assert.equal(said?.[1], controlName(setting), key);
  }
});
