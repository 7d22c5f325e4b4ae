// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { kProcesses, kSettings } from '../generated/settings.js';
import { kLanguages, load } from '../i18n/locales.js';
import { SettingFields, broughtBy, controlValues } from './setting_fields.js';

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

const fields = new SettingFields(kControls, kDefaults);
/** @param {import('../storage/last_work.js').Values} change */
const settings = (change) => fields.settings({ ...kDefaults, ...change }, 'a');

test('Values and settings convert into each other', () => {
  assert.deepEqual(fields.valuesFor(settings({})), kDefaults);
  assert.deepEqual(fields.settings(held({ size: 31.5, ecc: 'Q' }), 'a'), {
    ...fields.settings(held(), 'a'),
    size: 31.5,
    maxSizeMm: 31.5,
    ecc: 'Q',
  });
  const { mask, minWallMm, quietZone, light } = /** @type {any} */ (
    settings({ mask: '3', 'min-wall': '0', light: '90,45,1' })
  );
  assert.deepEqual([mask, minWallMm, quietZone], [3, 0, true]);
  assert.deepEqual(light, [{ azimuthDeg: 90, elevationDeg: 45, strength: 1 }]);
});

test('An empty optional field is left out', () => {
  const given = settings({ contrast: '', version: '', ecc: 'auto' });
  for (const key of ['contrast', 'version', 'light', 'ecc']) assert.equal(key in given, false, key);
});

test('A text is taken as typed; an empty one is left out', () => {
  assert.equal('label' in settings({ label: '' }), false);
  assert.equal(/** @type {any} */ (settings({ label: ' No. 007' })).label, ' No. 007');
  assert.equal(held(/** @type {any} */ ({ label: 'No. 7' })).label, 'No. 7');
  assert.equal('label' in settings({ label: 'No. 7', content: 'text' }), false, 'a text alone takes none');
});

test('A missing, malformed or out-of-range number is refused with the range', () => {
  const range = { from: { number: 0 }, to: { number: 1000 } };
  const wall = { setting: { setting: 'minWallMm' }, ...range };
  assert.throws(() => settings({ 'min-wall': '' }), { code: 'control-not-a-number', values: wall });
  assert.throws(() => settings({ contrast: '?' }), { code: 'control-not-a-number' });
  assert.throws(() => settings({ 'min-wall': '-1' }), {
    code: 'control-out-of-range',
    values: { ...wall, value: { number: -1 } },
  });
  assert.throws(() => settings({ version: '2.5' }), { code: 'control-out-of-range' });
  assert.throws(() => settings({ light: '90' }), { code: 'setting-no-lamps' });
});

test('A refused width is named like its field', () => {
  const labelOf = (/** @type {import('../storage/last_work.js').Values} */ change) => {
    try {
      return settings(change);
    } catch (thrown) {
      return /** @type {any} */ (thrown).values.setting.setting;
    }
  };
  assert.equal(labelOf({ size: 'fixed', 'size-mm': '' }), 'sizeMm');
  assert.equal(labelOf({ size: 'free', 'size-mm': '' }), 'maxSizeMm');
});

test('A changed setting changes its dependent settings; an empty choice becomes automatic', () => {
  const after = (/** @type {string} */ setting, /** @type {string} */ value) =>
    fields.after({ ...kDefaults, light: '90,45,1' }, { setting, value });
  assert.equal(after('preset', 'robust').preset, 'robust');
  assert.equal(after('ecc', '').ecc, 'auto');
  assert.equal(after('contrast', '').contrast, '');
  assert.equal(after('quietZone', 'false')['quiet-zone'], false);
  assert.equal(after('objective', 'contrast').light, '');
  const { nozzleMm } = /** @type {any} */ (kProcesses['resin-0.05']);
  assert.equal(after('process', 'resin-0.05').nozzle, String(nozzleMm));
  assert.throws(() => after('blurModules', '1'), /no control/);
});

test('A direction is a choice or a vector', () => {
  const given = (/** @type {string} */ value) => /** @type {any} */ (settings({ 'build-up': value })).buildUp;
  assert.deepEqual(given('0,-0.6,0.8'), [0, -0.6, 0.8]);
  assert.equal(given('code-up'), 'code-up');
  assert.equal(held(/** @type {any} */ ({ buildUp: [0, -0.6, 0.8] }))['build-up'], '0,-0.6,0.8');
  for (const value of ['0,0,1', 'code-upright'])
    assert.equal(fields.restored(kDefaults, { 'build-up': value })['build-up'], value);
  for (const value of ['0,0', '0,0,', '0,0,up', '0,0,1,2', ''])
    assert.equal(fields.restored(kDefaults, { 'build-up': value })['build-up'], 'as-modelled');
});

test('Only possible values of known controls are restored', () => {
  const now = { ...kDefaults, preset: 'robust', nozzle: '0.25' };
  const restored = fields.restored(now, { preset: 'shallow', contrast: '?', mask: '3', size: 'fixed', gone: 'x' });
  assert.deepEqual(restored, { ...now, preset: 'shallow', contrast: '', mask: '3', size: 'fixed' });
  assert.deepEqual(fields.restored(now, { preset: 'gone', mask: 'gone' }), now);
});
