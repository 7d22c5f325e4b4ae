// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { kProcesses, kSettings } from '../generated/settings.js';
import { settings as kWords } from '../i18n/parts/settings.js';
import { broughtBy, controlValues } from './settings_form.js';

/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */

const page = readFileSync(new URL('../index.html', import.meta.url), 'utf8');
const kControls = [...page.matchAll(/id="([^"]+)" data-setting="([^"]+)"/g)].map(([, id, key]) => ({
  id,
  key: /** @type {SettingKey} */ (key),
}));
const kDefaults = Object.fromEntries(
  kControls.map(({ id, key }) => {
    const { default: initial } = kSettings[key];
    return [id, typeof initial === 'boolean' ? initial : initial === null ? '' : String(initial)];
  }),
);

/** @type {import('../engine/types.js').Settings} */
const kGiven = {
  text: 'a',
  preset: 'robust',
  pattern: 'square',
  finderPattern: 'diamond',
  size: 'best',
  maxSizeMm: 35,
  quietZone: false,
  direction: 'pca',
  rotateDeg: -12.5,
  minWallMm: 0,
  nozzleMm: 0.25,
  layerMm: 0.15,
  eyeDistanceMm: 300,
};
const kHeld = {
  preset: 'robust',
  pattern: 'square',
  'finder-pattern': 'diamond',
  size: 'best',
  'size-mm': '35',
  'quiet-zone': false,
  direction: 'pca',
  rotate: '-12.5',
  'min-wall': '0',
  nozzle: '0.25',
  layer: '0.15',
  'eye-distance': '300',
  ecc: 'auto',
  contrast: '',
  'max-depth': '',
  light: '',
};

/** @param {Partial<import('../engine/types.js').Settings>} [change] */
const held = (change) => controlValues({ ...kGiven, ...change }, kControls, kDefaults);

test('Every control of a setting shows its value; missing settings get their defaults', () => {
  assert.deepEqual(Object.fromEntries(Object.keys(kHeld).map((id) => [id, held()[id]])), kHeld);
  assert.deepEqual(
    Object.keys(held()),
    kControls.map(({ id }) => id),
  );
});

test('Given settings are not missing', () => {
  assert.deepEqual(held({ ecc: 'Q', contrast: 0.3, maxDepthMm: 1.5 }), {
    ...held(),
    ecc: 'Q',
    contrast: '0.3',
    'max-depth': '1.5',
  });
});

test('A size in mm is exact, and the control of the largest size keeps it', () => {
  assert.deepEqual(held({ size: 31.5 }), { ...held(), size: 'fixed', 'size-mm': '31.5' });
});

test('Lamps are kept as typed', () => {
  const light = [
    { azimuthDeg: 90, elevationDeg: 45, strength: 1 },
    { azimuthDeg: 180, elevationDeg: 30 },
  ];
  assert.deepEqual(held({ light }), { ...held(), light: '90,45,1 180,30' });
});

test('A process sets its printer, an objective for any light removes the lamp, and others change nothing', () => {
  assert.deepEqual(
    broughtBy({ setting: 'process', value: 'resin-0.05' }),
    Object.fromEntries(Object.entries(kProcesses['resin-0.05']).map(([key, value]) => [key, String(value)])),
  );
  assert.deepEqual(broughtBy({ setting: 'process', value: 'none' }), {});
  assert.deepEqual(broughtBy({ setting: 'objective', value: 'contrast' }), { light: '' });
  assert.deepEqual(broughtBy({ setting: 'objective', value: 'one-light' }), {});
  assert.deepEqual(broughtBy({ setting: 'contrast', value: '0.3' }), {});
});

test('Every setting that follows another has a control', () => {
  const brought = [
    ...Object.keys(kProcesses).map((value) => ({ setting: 'process', value })),
    { setting: 'objective', value: 'contrast' },
  ].map(broughtBy);
  for (const key of brought.flatMap(Object.keys))
    assert.ok(
      kControls.some((control) => control.key === key),
      key,
    );
});

test('The default lamp is the core’s', () => {
  const source = readFileSync(new URL('../../core/settings/engrave_request.h', import.meta.url), 'utf8');
  const [, ...lamp] =
    /kOneLight = \{\.azimuthDeg = (\d+), \.elevationDeg = (\d+), \.strength = (\d+)\}/.exec(source) ?? [];
  assert.equal(lamp.length, 3);
  for (const { lampHint } of Object.values(kWords)) assert.ok(lampHint.includes(`: ${lamp.join()},`), lampHint);
});
