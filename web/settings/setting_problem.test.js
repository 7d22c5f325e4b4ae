// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { kSettings } from '../generated/settings.js';
import { settingProblem } from './setting_problem.js';

/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */

const kKeys = /** @type {SettingKey[]} */ (Object.keys(kSettings));
const codeOf = (/** @type {SettingKey} */ key, /** @type {unknown} */ value) => settingProblem(key, value)?.code;

test('Every setting can have its default', () => {
  for (const key of kKeys.filter((one) => kSettings[one].default !== null))
    assert.equal(settingProblem(key, kSettings[key].default), undefined, key);
});

test('Every number is checked at both ends', () => {
  const numbers = kKeys.filter((key) => kSettings[key].min !== undefined);
  assert.ok(numbers.length > 7);
  for (const key of numbers) {
    const { min = 0, max = 0 } = kSettings[key];
    for (const value of [min, max]) assert.equal(settingProblem(key, value), undefined, key);
    for (const value of [min - 0.001, max * 1.001, Infinity]) assert.equal(codeOf(key, value), 'setting-out-of-range');
    assert.equal(codeOf(key, NaN), 'control-not-a-number');
  }
  assert.equal(codeOf('version', 2.5), 'setting-not-whole');
});

test('A refused number is named with its bounds, in its unit', () => {
  assert.deepEqual(settingProblem('minWallMm', -1)?.values, {
    setting: { setting: 'minWallMm' },
    value: { lengthMm: -1 },
    min: { lengthMm: 0 },
    max: { lengthMm: 1000 },
  });
  assert.deepEqual(settingProblem('rotateDeg', 400)?.values.value, { angleDeg: 400 });
  assert.deepEqual(settingProblem('albedo', 1)?.values.value, { number: 1 });
});

test('A value of another kind is refused with what was found', () => {
  for (const [key, value, code] of /** @type {[SettingKey, unknown, string][]} */ ([
    ['text', 5, 'setting-no-text'],
    ['quietZone', 1, 'setting-no-switch'],
    ['preset', 'deep', 'setting-no-choice'],
    ['pattern', ['square'], 'setting-no-choice'],
    ['ecc', null, 'setting-no-choice'],
    ['patternMask', '11111/11111/11111/11111/11111', 'setting-no-mask'],
    ['patternMask', '00100/01110', 'setting-no-mask'],
    ['patternMask', 11111, 'setting-no-mask'],
    ['nozzleMm', '0.4', 'setting-no-number'],
    ['size', 'huge', 'setting-no-choice-or-number'],
    ['direction', [0, 0, 1, 2], 'setting-no-choice-or-vector'],
    ['up', [0, null, 1], 'setting-no-vector'],
    ['light', '135,20,19', 'setting-no-lamps'],
    ['light', [{ azimuthDeg: 1 }], 'setting-no-lamps'],
  ]))
    assert.equal(codeOf(key, value), code, `${key} ${value}`);
  const found = settingProblem('preset', 'x'.repeat(1000))?.values.found;
  assert.deepEqual(found, { term: `"${'x'.repeat(38)}…` });
});

test('A mask of both kinds of submodules is accepted', () => {
  assert.equal(settingProblem('patternMask', '00100/01110/11111/01110/00100'), undefined);
});

test('A vector needs a length, and a choice may have one in its place', () => {
  assert.equal(settingProblem('buildUp', [0, -0.6, 0.8]), undefined);
  assert.equal(settingProblem('buildUp', 'code-up'), undefined);
  assert.equal(codeOf('buildUp', [0, 0, 0]), 'setting-no-length');
});

test('Lamps are counted, and their numbers are checked', () => {
  const lamp = { azimuthDeg: 90, elevationDeg: 45, strength: 1 };
  assert.equal(settingProblem('light', [lamp, { azimuthDeg: 180, elevationDeg: 30 }]), undefined);
  assert.equal(codeOf('light', [lamp, lamp, lamp]), 'setting-too-many');
  assert.deepEqual(settingProblem('light', [{ ...lamp, elevationDeg: 100 }])?.values.value, { angleDeg: 100 });
  assert.deepEqual(settingProblem('light', [{ ...lamp, azimuthDeg: NaN }])?.values.found, { quoted: '?,45,1' });
});
