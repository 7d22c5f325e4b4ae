// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { settingFrom, settingText } from './setting_text.js';

/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */

test('Values are read from text by the kind of their setting, and written alike', () => {
  for (const [key, text, value] of /** @type {[SettingKey, string, unknown][]} */ ([
    ['text', '007', '007'],
    ['quietZone', 'false', false],
    ['minWallMm', '0.8', 0.8],
    ['size', 'free', 'free'],
    ['size', '31.5', 31.5],
    ['mask', '3', 3],
    ['buildUp', '0,-0.6,0.8', [0, -0.6, 0.8]],
    ['direction', 'pca', 'pca'],
    [
      'light',
      '90,45,1 180,30',
      [
        { azimuthDeg: 90, elevationDeg: 45, strength: 1 },
        { azimuthDeg: 180, elevationDeg: 30 },
      ],
    ],
  ])) {
    assert.deepEqual(settingFrom(key, text), value, key);
    assert.equal(settingText(value), text, key);
  }
  assert.equal(settingText(undefined), '');
});

test('A text that is no value of the setting comes back as it is', () => {
  for (const [key, text] of /** @type {[SettingKey, string][]} */ ([
    ['quietZone', 'yes'],
    ['minWallMm', ''],
    ['minWallMm', 'thick'],
    ['buildUp', '0,0'],
    ['buildUp', '0,0,'],
    ['buildUp', '0,0,up'],
    ['light', '90'],
  ]))
    assert.equal(settingFrom(key, text), text, key);
});
