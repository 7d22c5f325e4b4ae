// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { kLanguages, load } from '../i18n/locales.js';
import { defaultsOf, keysOf, settingsAfter } from '../settings/work_settings.js';
import { settingProblem } from '../settings/setting_problem.js';
import { fieldChange, fieldText, fieldValue, kFirstMask, kOwn } from './setting_fields.js';

/** @typedef {import('./setting_fields.js').FieldKey} FieldKey */

const page = readFileSync(new URL('../index.html', import.meta.url), 'utf8');
const kDefaults = defaultsOf([...page.matchAll(/data-setting="([^"]+)"/g)].map(([, key]) => /** @type {any} */ (key)));

test('What a control shows stands for its setting', () => {
  const settings = {
    ...kDefaults,
    buildUp: /** @type {any} */ ([0, -0.6, 0.8]),
    mask: 3,
    quietZone: false,
    up: /** @type {any} */ ([0, 0.6, 0.8]),
  };
  for (const key of keysOf(settings))
    if (key !== 'light') assert.deepEqual(fieldValue(key, fieldText(key, settings)), settings[key], key);
});

test('A field without a number is empty if its setting may be, and else misses one', () => {
  assert.equal(fieldValue('contrast', ''), undefined);
  assert.equal(fieldValue('label', ''), undefined);
  assert.equal(fieldValue('up', ''), undefined);
  for (const [key, text] of /** @type {[FieldKey, string][]} */ ([
    ['minWallMm', ''],
    ['minWallMm', 'NaN'],
    ['contrast', 'NaN'],
  ]))
    assert.ok(Number.isNaN(fieldValue(key, text)), key);
});

test('A fixed size is a choice and the number beside it, which else limits the size', () => {
  const [free, fixed] = [
    { ...kDefaults, maxSizeMm: 35 },
    { ...kDefaults, maxSizeMm: 35, size: 31.5 },
  ];
  assert.deepEqual([fieldText('size', free), fieldText('maxSizeMm', free)], ['best', '35']);
  assert.deepEqual([fieldText('size', fixed), fieldText('maxSizeMm', fixed)], ['fixed', '31.5']);
  assert.deepEqual(fieldChange('size', 'fixed', free), { size: 35 });
  assert.deepEqual(fieldChange('size', 'fixed', free, 28.31), { size: 28.31 });
  assert.deepEqual(fieldChange('size', 'free', fixed), { size: 'free' });
  assert.deepEqual(fieldChange('maxSizeMm', '21', free), { maxSizeMm: 21 });
  assert.deepEqual(fieldChange('maxSizeMm', '21', fixed), { size: 21 }); // the largest size stays known
});

test('A pattern of one’s own is a choice and the grid below it', () => {
  const own = { ...kDefaults, patternMask: '11111/10001/10001/10001/11111' };
  assert.equal(fieldText('pattern', own), kOwn);
  assert.equal(fieldText('pattern', kDefaults), 'auto');
  assert.deepEqual(fieldChange('pattern', kOwn, kDefaults), { patternMask: kFirstMask });
  assert.equal(settingProblem('patternMask', kFirstMask), undefined);
  assert.deepEqual(fieldChange('pattern', 'square', own), { pattern: 'square', patternMask: undefined });
  assert.deepEqual(settingsAfter(own, fieldChange('pattern', 'square', own)), { ...kDefaults, pattern: 'square' });
});

test('The default lamp is the core’s', async () => {
  const source = readFileSync(new URL('../../core/settings/engrave_request.h', import.meta.url), 'utf8');
  const [, ...lamp] =
    /kOneLight = \{\.azimuthDeg = (\d+), \.elevationDeg = (\d+), \.strength = (\d+)\}/.exec(source) ?? [];
  assert.equal(lamp.length, 3);
  for (const { code } of kLanguages) {
    const { lampHint } = (await load(code, 'app')).page.settings;
    assert.ok(lampHint.includes(lamp.join()), lampHint);
  }
});
