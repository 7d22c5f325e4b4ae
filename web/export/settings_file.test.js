// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { kSettings as kTable } from '../generated/settings.js';
import { EngineFailure } from '../engine/engine_error.js';
import { messageWords } from '../i18n/message_words.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';
import { fileKeys, looksLikeSettings, readSettingsFile as readFile, writeSettingsFile } from './settings_file.js';

await messageWords.load();

/** Settings that have a control on the page. @type {import('../generated/settings.js').SettingKey[]} */
const kControls = [
  ...readFileSync(new URL('../index.html', import.meta.url), 'utf8').matchAll(/data-setting="([^"]+)"/g),
].map(([, key]) => /** @type {any} */ (key));
const kFileKeys = fileKeys(kControls);
/** @param {string} json @param {string} name */
const readSettingsFile = (json, name) => readFile(json, name, kControls);

/** @type {import('../engine/types.js').Settings} */
const kSettings = {
  ...Object.fromEntries(
    kFileKeys.flatMap((key) => (kTable[key].mayBeEmpty || key === 'ecc' ? [] : [[key, kTable[key].default]])),
  ),
  text: 'Grüße\n"☕"',
  preset: 'robust',
  pattern: 'square',
  finderPattern: 'diamond',
  size: 31.5,
  maxSizeMm: 40,
  quietZone: true,
  direction: 'pca',
  rotateDeg: -12.5,
  minWallMm: 0,
  nozzleMm: 0.4,
  layerMm: 0.1,
  eyeDistanceMm: 250,
};
/** @type {import('./settings_file.js').ModelChoice} */
const kModel = { file: 'bunny.stl', sample: 'bunny', scaleToMm: 1, upAxis: 'z', centreMm: [1.25, -3, 0] };

/** Returns the file's content with other values. @param {any} change */
const changed = (change) =>
  JSON.stringify({ ...JSON.parse(writeSettingsFile({ settings: kSettings, model: kModel })), ...change });

/** @param {Record<string, unknown>} change */
const withSettings = (change) => changed({ settings: { ...kSettings, ...change } });

test('a written file can be read again, with and without a model', () => {
  const whole = {
    settings: {
      ...kSettings,
      ecc: /** @type {const} */ ('Q'),
      contrast: 0.3,
      maxDepthMm: 1.5,
      up: /** @type {[number, number, number]} */ ([0, 0, -1]),
      albedo: 0.85,
      light: [{ azimuthDeg: 135, elevationDeg: 20, strength: 19 }],
    },
    model: kModel,
  };
  assert.deepEqual(readSettingsFile(writeSettingsFile(whole), 'x.json'), whole);
  assert.deepEqual(readSettingsFile(`\ufeff${writeSettingsFile({ settings: kSettings })}`, 'x.json'), {
    settings: kSettings,
  });
  assert.equal(readSettingsFile(withSettings({ light: undefined }), 'x.json').settings.light, undefined);
  for (const size of /** @type {const} */ (['free', 'oriented', 'best'])) {
    assert.equal(readSettingsFile(withSettings({ size }), 'x.json').settings.size, size);
  }
});

/** @param {RegExp} sentence */
const refusedWith = (sentence) => (/** @type {unknown} */ thrown) =>
  thrown instanceof EngineFailure &&
  thrown.kind === 'BadInput' &&
  sentence.test(`${sentenceOf(thrown)}. ${hintOf(thrown)}`);

test('another kind of file is refused by name', () => {
  const refused = [
    ['', /x\.json” is not a JSON file/],
    ['solid bunny', /not a JSON/],
    ['[]', /no QRelief settings/],
    ['null', /no QRelief settings/],
    ['{}', /no QRelief settings/],
    ['{"qrelief": "0.1.0", "text": "a"}', /x\.json” is a report/],
    [changed({ version: 2 }), /settings of version 2; this page uses version 1/],
    [changed({ version: undefined }), /version undefined/],
    [changed({ settings: [] }), /settings is missing/],
    [`"${'x'.repeat(2 ** 20)}"`, /no QRelief settings/],
  ];
  for (const [json, message] of refused) {
    assert.throws(
      () => readSettingsFile(/** @type {string} */ (json), 'x.json'),
      refusedWith(/** @type {RegExp} */ (message)),
    );
  }
});

test('every wrong setting is named with its value', () => {
  const wrong = [
    [{ text: 5 }, /“Text or link” is 5, which is not text/],
    [{ preset: 'deep' }, /“How deep” is "deep", which is not one of its choices/],
    [{ nozzleMm: null }, /“Nozzle” is null, which is not a number/],
    [{ contrast: 1 }, /“Contrast” is 1. Choose from 0.01 to 0.99/],
    [{ text: undefined }, /text is missing/],
    [{ colour: 'red' }, /no setting "colour"/],
    [{ ['__proto__x']: 1 }, /no setting/],
  ];
  for (const [change, message] of wrong) {
    assert.throws(
      () => readSettingsFile(withSettings(/** @type {any} */ (change)), 'x.json'),
      refusedWith(/** @type {RegExp} */ (message)),
    );
  }
});

test('every wrong property of the model is named', () => {
  const wrong = [
    [null, /model in the settings is null/],
    [{ ...kModel, file: 1 }, /model in the settings is 1/],
    [{ ...kModel, scaleToMm: 0 }, /“Unit” is 0/],
    [{ ...kModel, upAxis: 'x' }, /is "x", which is not one of its choices/],
    [{ ...kModel, centreMm: [1, 2] }, /centre .* must be three numbers, not \[1,2\]/],
    [{ ...kModel, centreMm: [1, 2, null] }, /three numbers/],
  ];
  for (const [model, message] of wrong) {
    assert.throws(() => readSettingsFile(changed({ model }), 'x.json'), refusedWith(/** @type {RegExp} */ (message)));
  }
});

test('a file truncated anywhere is refused', () => {
  const whole = writeSettingsFile({ settings: kSettings, model: kModel }).trimEnd();
  for (let length = 0; length < whole.length; length += 1) {
    assert.throws(() => readSettingsFile(whole.slice(0, length), 'x.json'), { name: 'EngineError' });
  }
});

test('a file has the text and every setting with a control', () => {
  assert.deepEqual([...kControls, 'text'].sort(), [...kFileKeys].sort());
  assert.ok(kControls.every((key) => key in kTable));
});

test('any setting but the text may be missing', () => {
  for (const key of kFileKeys.filter((one) => one !== 'text')) {
    const { [key]: _, ...rest } = /** @type {Record<string, unknown>} */ (kSettings);
    assert.deepEqual(readSettingsFile(withSettings({ [key]: undefined }), 'x.json').settings, rest, key);
  }
});

test('settings are distinguished from models by name or type', () => {
  assert.ok(looksLikeSettings({ name: 'a.JSON', type: '' }));
  assert.ok(looksLikeSettings({ name: 'a', type: 'application/json' }));
  assert.ok(!looksLikeSettings({ name: 'a.json.stl', type: 'model/stl' }));
});
