// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { after, before, beforeEach, test } from 'node:test';
import { showWork } from './showing.js';
import { storeOf } from './testing.js';
import { centredAt } from './work.js';

class FakeElement {
  textContent = '';
}
const { document: realDocument, HTMLElement: realElement } = globalThis;
const summary = new FakeElement();
const parts = ['shadow', 'inlay', 'inlay paint'].map((marks) => ({ dataset: { marks }, hidden: false }));

/** @type {import('./work_store.js').WorkStore} */ let store;
/** @type {any[][]} */ let calls;

before(() =>
  Object.assign(globalThis, {
    document: { getElementById: () => summary, querySelectorAll: () => parts },
    HTMLElement: FakeElement,
  }),
);
after(() => Object.assign(globalThis, { document: realDocument, HTMLElement: realElement }));
beforeEach(() => {
  store = storeOf({ values: { mark: 'shadow', preset: 'balanced', nozzle: '0.4' } });
  calls = [];
  const shows = (/** @type {string} */ panel) => (/** @type {any} */ part) => void calls.push([panel, part]);
  showWork(store, {
    form: { show: shows('form') },
    code: { show: shows('code') },
    place: { showCentre: shows('place') },
    batch: { showInput: shows('batch') },
  });
});

test('A panel is updated only if its part of the work changes', () => {
  store.update({ text: 'b' });
  store.update({ centreIsGuess: true });
  store.update(centredAt([1, 2, 3]));
  store.update({ batch: /** @type {any} */ ({ from: 'count' }) });
  store.update({ values: { preset: 'robust', nozzle: '0.25' } });
  assert.deepEqual(calls, [
    ['code', 'b'],
    ['place', [1, 2, 3]],
    ['batch', { from: 'count' }],
    ['form', { preset: 'robust', nozzle: '0.25' }],
  ]);
});

test('Without a centre the fields keep their values', () => {
  store.update(centredAt([1, 2, 3]));
  store.update(centredAt(undefined));
  assert.deepEqual(calls, [['place', [1, 2, 3]]]);
});

test('One line sums up the carving from the start', () => {
  assert.match(summary.textContent, /^Balanced.*0\.4/);
  store.update({ values: { mark: 'shadow', preset: 'robust', nozzle: '' } });
  assert.match(summary.textContent, /^Robust.*\?/);
  store.update({ values: { mark: 'paint', preset: 'robust', nozzle: '0.4' } });
  assert.match(summary.textContent, /^Second colour, painted.*0\.4/);
});

test('Settings without an effect on the mark are hidden', () => {
  const hidden = () => parts.map((part) => part.hidden);
  assert.deepEqual(hidden(), [false, true, true]);
  store.update({ values: { mark: 'inlay' } });
  assert.deepEqual(hidden(), [true, false, false]);
  store.update({ values: { mark: 'paint' } });
  assert.deepEqual(hidden(), [true, true, false]);
});
