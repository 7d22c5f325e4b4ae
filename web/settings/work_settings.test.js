// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { kProcesses, kSettings } from '../generated/settings.js';
import {
  defaultsOf,
  proposedChange,
  requestedSettings,
  restoredSettings,
  sameSettings,
  settingsAfter,
  settingsForAnother,
} from './work_settings.js';

const kKeys = /** @type {import('../generated/settings.js').SettingKey[]} */ (Object.keys(kSettings));
const kDefaults = defaultsOf(kKeys.filter((key) => key !== 'text'));
const kLamp = { azimuthDeg: 90, elevationDeg: 45, strength: 1 };

test('The defaults can be requested; a setting without a value is left out', () => {
  const request = requestedSettings(kDefaults, 'a');
  assert.equal(request.text, 'a');
  for (const key of ['contrast', 'version', 'light', 'label', 'up']) assert.equal(key in request, false, key);
  assert.deepEqual([request.ecc, request.minWallMm, request.quietZone], ['auto', 0.8, true]);
});

test('A text alone takes no label', () => {
  assert.equal(requestedSettings({ label: 'No. 7' }, 'a').label, 'No. 7');
  assert.equal('label' in requestedSettings({ label: 'No. 7', content: 'text' }, 'a'), false);
});

test('Settings that cannot have their value are not requested', () => {
  assert.throws(() => requestedSettings({ minWallMm: NaN }, 'a'), { code: 'control-not-a-number', kind: 'BadUsage' });
  assert.throws(() => requestedSettings({ minWallMm: -1 }, 'a'), { code: 'setting-out-of-range' });
  assert.throws(() => requestedSettings({ light: [{ ...kLamp, azimuthDeg: NaN }] }, 'a'), { code: 'setting-no-lamps' });
});

test('Settings are the same by value', () => {
  assert.ok(
    sameSettings({ light: [kLamp], minWallMm: NaN }, { light: [{ ...kLamp }], minWallMm: NaN, contrast: undefined }),
  );
  assert.ok(!sameSettings({ light: [kLamp] }, {}));
  assert.ok(!sameSettings({}, { contrast: 0.3 }));
  assert.ok(!sameSettings({ light: [{ ...kLamp, azimuthDeg: NaN }] }, { light: [{ ...kLamp, elevationDeg: NaN }] }));
});

test('A process sets its printer, an objective for any light removes the lamps, and others change nothing', () => {
  const before = { ...kDefaults, light: [kLamp] };
  const after = (/** @type {import('./work_settings.js').WorkSettings} */ change) => settingsAfter(before, change);
  assert.deepEqual(after({ process: 'resin-0.05' }), { ...before, process: 'resin-0.05', ...kProcesses['resin-0.05'] });
  assert.deepEqual(after({ process: 'none' }), { ...before, process: 'none' });
  assert.deepEqual(after({ objective: 'contrast' }), { ...before, light: undefined });
  assert.deepEqual(after({ objective: 'one-light' }), { ...before, objective: 'one-light' });
  assert.deepEqual(after({ contrast: 0.3 }), { ...before, contrast: 0.3 });
});

test('A proposed change has a text, and none for the default', () => {
  const change = (/** @type {string} */ setting, /** @type {string} */ value) => proposedChange({ setting, value });
  assert.deepEqual(change('preset', 'robust'), { preset: 'robust' });
  assert.deepEqual(change('nozzleMm', '0.15'), { nozzleMm: 0.15 });
  assert.deepEqual(change('quietZone', 'false'), { quietZone: false });
  assert.deepEqual(change('ecc', ''), { ecc: 'auto' });
  assert.deepEqual(change('contrast', ''), { contrast: undefined });
  assert.deepEqual(change('up', '1,0,0'), { up: [1, 0, 0] });
  assert.deepEqual(change('up', ''), { up: undefined });
  assert.throws(() => change('blurModules', '1'), /no setting/);
});

test('Earlier settings are restored; the others get their defaults', () => {
  const defaults = {
    preset: /** @type {const} */ ('balanced'),
    contrast: undefined,
    size: /** @type {const} */ ('best'),
    minWallMm: 0.8,
  };
  const restored = (/** @type {any} */ earlier) => restoredSettings(earlier, defaults);
  assert.deepEqual(restored({ preset: 'shallow', contrast: 0.3, size: 31.5, minWallMm: -1 }), {
    preset: 'shallow',
    contrast: 0.3,
    size: 31.5,
    minWallMm: -1,
  });
  assert.deepEqual(restored({ preset: 'gone', size: 'gone', minWallMm: NaN, other: 1 }), defaults);
});

test('A size and a rotation made for one model do not follow to the next', () => {
  const next = (/** @type {any} */ settings, asked = {}) => settingsForAnother({ ...kDefaults, ...settings }, asked);
  const first = { ...kDefaults, minWallMm: 1 };
  for (const made of [
    { size: 24.6 },
    { size: 24.6, rotateDeg: 15 },
    { size: 'oriented', rotateDeg: 15 },
    { size: NaN },
  ])
    assert.deepEqual(next({ ...made, minWallMm: 1 }), first, JSON.stringify(made));
});

test('A choice of size follows to the next model, and so do size and rotation that were asked for', () => {
  for (const [size, rotateDeg, asked] of /** @type {[any, number, any][]} */ ([
    ['oriented', 0, {}],
    [15, 0, { size: 15, rotateDeg: 0 }],
    ['oriented', 30, { size: 'oriented', rotateDeg: 30 }],
  ])) {
    const settings = { ...kDefaults, size, rotateDeg };
    assert.deepEqual(settingsForAnother(settings, asked), settings);
  }
  const changed = { ...kDefaults, size: 20 };
  assert.deepEqual(settingsForAnother(changed, { size: 15, rotateDeg: 0 }), kDefaults, 'the user changed it since');
});
