// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { after, before, beforeEach, test } from 'node:test';
import { DownloadChoice } from './download_choice.js';

class FakeElement extends EventTarget {
  hidden = false;
  textContent = '';
}

class FakeSelect extends FakeElement {
  /** @param {string} id @param {string[]} values */
  constructor(id, values) {
    super();
    this.id = id;
    this.options = values.map((value) => ({ value, hidden: false, disabled: false }));
    [this.value] = values;
  }
  /** @param {string} value */
  choose(value) {
    this.value = value;
    this.dispatchEvent(new Event('change'));
  }
}

const kNames = ['document', 'HTMLElement', 'HTMLSelectElement', 'localStorage'];
const kReal = Object.fromEntries(kNames.map((name) => [name, Object.getOwnPropertyDescriptor(globalThis, name)]));
/** @type {Map<string, string>} */ let storage;
/** @type {Record<string, FakeElement>} */ let elements;
/** @type {FakeSelect} */ let format;
/** @type {FakeSelect} */ let slicer;

before(() => {
  const set = (/** @type {string} */ name, /** @type {unknown} */ value) =>
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  set('document', { getElementById: (/** @type {string} */ id) => elements[id] });
  set('HTMLElement', FakeElement);
  set('HTMLSelectElement', FakeSelect);
  set('localStorage', {
    getItem: (/** @type {string} */ key) => storage.get(key) ?? null,
    setItem: (/** @type {string} */ key, /** @type {string} */ value) => storage.set(key, value),
  });
});
after(() => {
  for (const [name, real] of Object.entries(kReal))
    if (real) Object.defineProperty(globalThis, name, real);
    else Reflect.deleteProperty(globalThis, name);
});
beforeEach(() => {
  storage = new Map();
  renew();
});

/** @type {import('../engine/types.js').ModelInfo['only3mf']} */ const kNothing = [];
const words = () => (elements['format-why'].hidden ? '' : elements['format-why'].textContent);

function renew() {
  format = new FakeSelect('format', ['stl', '3mf', '3mf-inlay', 'obj']);
  slicer = new FakeSelect('slicer', ['any', 'prusa']);
  elements = { format, slicer, 'slicer-field': new FakeElement(), 'format-why': new FakeElement() };
}

test('A code in colour has one format; the earlier choice comes back with a code of one colour', () => {
  const choice = new DownloadChoice();
  format.choose('obj');
  choice.offerFor('paint', kNothing);
  assert.deepEqual(choice.chosen, { format: '3mf-inlay', slicer: 'any' });
  assert.deepEqual(
    format.options.filter(({ disabled, hidden }) => !disabled && !hidden).map(({ value }) => value),
    ['3mf-inlay'],
  );
  assert.equal(elements['format-why'].hidden, false);
  choice.offerFor('shadow', kNothing);
  assert.equal(choice.chosen.format, 'obj');
  assert.ok(format.options.every(({ disabled, hidden }) => !disabled && !hidden));
  assert.equal(elements['format-why'].hidden, true);
});

test('The slicer is offered for two colours only', () => {
  const choice = new DownloadChoice();
  assert.equal(elements['slicer-field'].hidden, true);
  format.choose('3mf-inlay');
  assert.equal(elements['slicer-field'].hidden, false);
  slicer.choose('prusa');
  assert.deepEqual(choice.chosen, { format: '3mf-inlay', slicer: 'prusa' });
});

test('Format and slicer are kept for the next visit', () => {
  assert.ok(new DownloadChoice());
  format.choose('3mf-inlay');
  slicer.choose('prusa');
  renew();
  assert.deepEqual(new DownloadChoice().chosen, { format: '3mf-inlay', slicer: 'prusa' });
});

test('An inlaid code is one file in two colours, or two STL files if the user says so', () => {
  const choice = new DownloadChoice();
  choice.offerFor('inlay', kNothing);
  assert.equal(choice.chosen.format, '3mf-inlay');
  assert.match(words(), /^Only 3MF holds both colours/);
  assert.deepEqual(
    format.options.filter(({ disabled }) => !disabled).map(({ value }) => value),
    ['stl', '3mf-inlay'],
  );
  format.choose('stl');
  assert.match(words(), /^A ZIP with two STL files/);
  choice.offerFor('inlay', kNothing);
  assert.equal(choice.chosen.format, 'stl');
  assert.equal(storage.get('qrelief.format'), undefined, 'the choice for one colour stays');
});

test('A file with paint or plates is saved as 3MF with the reason, unless the user chooses otherwise for this model', () => {
  const choice = new DownloadChoice();
  format.choose('obj');
  for (const [only3mf, why] of /** @type {const} */ ([
    [['paint'], /painted facets of/],
    [['plates'], /plates of/],
    [['paint', 'plates'], /painted facets and the plates/],
  ])) {
    const contents = [...only3mf];
    choice.offerFor('shadow', contents);
    assert.equal(choice.chosen.format, '3mf');
    assert.match(words(), why);
    format.choose('stl');
    choice.offerFor('shadow', contents);
    assert.equal(choice.chosen.format, 'stl');
    assert.match(words(), why);
  }
  choice.offerFor('shadow', kNothing);
  assert.equal(choice.chosen.format, 'stl');
  assert.equal(words(), '');
});
