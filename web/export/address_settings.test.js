// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { addressFor, settingsFromAddress, spotFromAddress } from './address_settings.js';

/** @type {import('../generated/settings.js').SettingKey[]} */
const kControls = ['pattern', 'contrast', 'maxSizeMm', 'light', 'keepPreset', 'mask', 'mark', 'label', 'up'];
const read = (/** @type {string} */ query) => settingsFromAddress(new URLSearchParams(query), kControls);

test('settings are read by name and kind', () => {
  assert.deepEqual(
    read('sample=bunny&text=HELLO&pattern=square&contrast=0.4&light=90,33,1+180,20&keepPreset=true&mask=3'),
    {
      pattern: 'square',
      contrast: 0.4,
      light: [
        { azimuthDeg: 90, elevationDeg: 33, strength: 1 },
        { azimuthDeg: 180, elevationDeg: 20 },
      ],
      keepPreset: true,
      mask: 3,
    },
  );
  assert.deepEqual(read('mask=shadiest&finderPattern=none'), { mask: 'shadiest' }, 'what has no control is left out');
  assert.deepEqual(read('text=HELLO&mark=paint&label=No.%207'), { mark: 'paint', label: 'No. 7' });
  assert.deepEqual(read('sample=bunny'), {});
});

test('an invalid value is refused with the reason', () => {
  for (const query of [
    'pattern=star',
    'contrast=2',
    'contrast=',
    'light=90',
    'keepPreset=yes',
    'mask=9',
    'up=0,0,0',
    'up=',
  ]) {
    assert.throws(() => read(query), { code: 'settings-address-refused' }, query);
  }
});

test('an address has the text, the sample with its spot, and the settings that differ; it is read as it was written', () => {
  const defaults = /** @type {any} */ ({ text: '', pattern: 'none', contrast: 0.25, keepPreset: false, maxSizeMm: 30 });
  const settings = /** @type {any} */ ({
    ...defaults,
    text: 'a & b = „ö“',
    pattern: 'square',
    keepPreset: true,
    up: [0, 0.6, 0.8],
    light: [{ azimuthDeg: 90, elevationDeg: 33, strength: 1 }],
  });
  const model = { file: 'owl.stl', sample: 'owl', scaleToMm: 1, upAxis: /** @type {const} */ ('z') };
  const address = new URLSearchParams(
    String(addressFor({ settings, defaults, model: { ...model, centreMm: [1.23456, -2, 0] } })),
  );
  assert.deepEqual([...address.keys()], ['sample', 'at', 'text', 'pattern', 'keepPreset', 'up', 'light']);
  assert.equal(address.get('text'), settings.text);
  assert.deepEqual(spotFromAddress(address), [1.23, -2, 0]);
  assert.deepEqual(settingsFromAddress(address, kControls), {
    pattern: 'square',
    keepPreset: true,
    up: settings.up,
    light: settings.light,
  });
});

test('an address has no spot on a model that it cannot name, and none that is not three numbers', () => {
  const settings = /** @type {any} */ ({ text: 'x' });
  const model = /** @type {any} */ ({ file: 'mine.stl', scaleToMm: 1, upAxis: 'z', centreMm: [1, 2, 3] });
  assert.equal(String(addressFor({ settings, defaults: settings, model })), 'text=x');
  for (const query of ['', 'at=', 'at=1,2', 'at=1,2,x', 'at=1,,3'])
    assert.equal(spotFromAddress(new URLSearchParams(query)), undefined, query);
});
