// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { after, before, beforeEach, test } from 'node:test';
import { showWork } from './show_work.js';
import { storeOf } from './testing.js';
import { centredAt } from './work.js';

class FakeElement {
  textContent = '';
}
const { document: realDocument, HTMLElement: realElement } = globalThis;
const summary = new FakeElement();
/** @type {{ dataset: Record<string, string>, hidden: boolean }[]} */
const parts = ['shadow', 'inlay', 'inlay paint'].map((marks) => ({ dataset: { marks }, hidden: false }));
parts.push(
  { dataset: { content: 'code' }, hidden: false },
  { dataset: { content: 'text', marks: 'shadow' }, hidden: false },
);

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
  store = storeOf({ settings: { content: 'code', mark: 'shadow', preset: 'balanced', nozzleMm: 0.4 } });
  calls = [];
  const shows = (/** @type {string} */ panel) => (/** @type {any} */ part) => void calls.push([panel, part]);
  showWork(store, {
    form: { show: shows('form') },
    code: { show: shows('code'), showMakes: shows('makes') },
    place: { showCentre: shows('place') },
    batch: { showInput: shows('batch') },
  });
});

test('A panel is updated only if its part of the work changes', () => {
  store.update({ text: 'b' });
  store.update({ centreIsGuess: true });
  store.update(centredAt([1, 2, 3]));
  store.update({ batch: /** @type {any} */ ({ from: 'count' }) });
  store.update({ settings: { content: 'code', preset: 'robust', nozzleMm: 0.25 } });
  assert.deepEqual(calls, [
    ['code', 'b'],
    ['place', [1, 2, 3]],
    ['batch', { from: 'count' }],
    ['form', { content: 'code', preset: 'robust', nozzleMm: 0.25 }],
  ]);
});

test('The panel of the code shows whether a code or a text alone is made', () => {
  store.update({ settings: { content: 'text' } });
  store.update({ settings: { content: 'text', mark: 'paint' } });
  store.update({ settings: { content: 'code' } });
  assert.deepEqual(
    calls.filter(([panel]) => panel === 'makes'),
    [
      ['makes', 'text'],
      ['makes', 'code'],
    ],
  );
});

test('Without a centre the fields keep their values', () => {
  store.update(centredAt([1, 2, 3]));
  store.update(centredAt(undefined));
  assert.deepEqual(calls, [['place', [1, 2, 3]]]);
});

test('One line sums up the carving from the start', () => {
  assert.match(summary.textContent, /^Balanced.*0\.4/);
  store.update({ settings: { mark: 'shadow', preset: 'robust', nozzleMm: NaN } });
  assert.match(summary.textContent, /^Robust.*\?/);
  store.update({ settings: { mark: 'paint', preset: 'robust', nozzleMm: 0.4 } });
  assert.match(summary.textContent, /^Second colour, painted.*0\.4/);
  store.update({ settings: { content: 'text', mark: 'shadow', preset: 'robust', nozzleMm: 0.4 } });
  assert.match(summary.textContent, /^Shadow.*0\.4/);
});

test('Settings without an effect on the mark or the content are hidden', () => {
  const hidden = () => parts.map((part) => part.hidden);
  assert.deepEqual(hidden(), [false, true, true, false, true]);
  store.update({ settings: { content: 'code', mark: 'inlay' } });
  assert.deepEqual(hidden(), [true, false, false, false, true]);
  store.update({ settings: { content: 'code', mark: 'paint' } });
  assert.deepEqual(hidden(), [true, true, false, false, true]);
  store.update({ settings: { content: 'text', mark: 'shadow' } });
  assert.deepEqual(hidden(), [false, true, true, true, false]);
  store.update({ settings: { content: 'text', mark: 'paint' } });
  assert.deepEqual(hidden(), [true, true, false, true, true]);
});
