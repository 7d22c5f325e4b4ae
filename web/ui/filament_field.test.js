// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { after, before, beforeEach, test } from 'node:test';
import { kSettings } from '../generated/settings.js';
import { setLanguage } from '../i18n/catalogue.js';
import { settingText } from '../settings/setting_text.js';
import { FilamentField, kFilaments } from './filament_field.js';

class FakeElement extends EventTarget {
  value = '';
  className = '';
  textContent = '';
  /** @type {FakeElement[]} */ options = [];
  /** @param {FakeElement[]} options */
  append(...options) {
    for (const option of options) option.remove = () => void this.options.splice(this.options.indexOf(option), 1);
    this.options.push(...options);
  }
  remove() {}
  querySelector() {
    return this.options.find(({ className }) => className === 'own');
  }
}

const kNames = ['document', 'HTMLInputElement', 'HTMLSelectElement'];
const kReal = Object.fromEntries(kNames.map((name) => [name, Object.getOwnPropertyDescriptor(globalThis, name)]));
/** @type {Record<string, FakeElement>} */ let elements;
/** @type {FilamentField} */ let field;

before(async () => {
  await setLanguage('en');
  const set = (/** @type {string} */ name, /** @type {unknown} */ value) =>
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  set('document', {
    getElementById: (/** @type {string} */ id) => elements[id],
    createElement: () => new FakeElement(),
  });
  set('HTMLInputElement', FakeElement);
  set('HTMLSelectElement', FakeElement);
});
after(() => {
  for (const [name, real] of Object.entries(kReal))
    if (real) Object.defineProperty(globalThis, name, real);
    else Reflect.deleteProperty(globalThis, name);
});
beforeEach(() => {
  elements = { filament: new FakeElement(), albedo: new FakeElement() };
  field = new FilamentField();
});

const names = () => elements.filament.options.map(({ textContent }) => textContent);
const shown = () =>
  elements.filament.options.find(({ value }) => value === elements.filament.value)?.textContent ?? 'nothing';

test('Every colour has an albedo of its own that leaves a shadow some contrast, and the default is one of them', () => {
  const albedos = kFilaments.map(({ albedo }) => albedo);
  assert.equal(new Set(albedos).size, albedos.length);
  const { max = 0, default: initial } = kSettings.albedo;
  assert.ok(albedos.every((albedo) => albedo === undefined || (albedo >= 0.3 && albedo <= max)));
  assert.ok(albedos.some((albedo) => settingText(albedo) === settingText(initial)));
});

test('The colour of the albedo is chosen; only another albedo has a choice of its own', () => {
  field.show(0.85);
  assert.equal(shown(), 'White');
  for (const albedo of [0.5, 0.51, NaN]) {
    field.show(albedo);
    assert.equal(shown(), 'Other');
    assert.equal(elements.filament.options.length, kFilaments.length + 1);
  }
  field.show(0.35);
  assert.equal(shown(), 'Medium grey');
  assert.ok(!names().includes('Other'));
  field.show();
  assert.equal(shown(), 'Automatic');
});

test('A chosen colour fills in its albedo, and the albedo’s control announces it', () => {
  /** @type {string[]} */ const announced = [];
  elements.albedo.addEventListener('change', () => announced.push(elements.albedo.value));
  field.show(0.7);
  elements.filament.value = '0.85';
  elements.filament.dispatchEvent(new Event('change'));
  elements.filament.value = '';
  elements.filament.dispatchEvent(new Event('change'));
  assert.deepEqual(announced, ['0.85', '']);
});

test('The colours are named in the chosen language', async () => {
  await setLanguage('de');
  assert.ok(names().includes('Weiß'));
  await setLanguage('en');
});
