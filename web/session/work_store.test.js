// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { WorkStore } from './work_store.js';

/** @type {WorkStore} */ let store;
/** @type {string[][]} */ let changes; // texts after and before each change

beforeEach(() => {
  store = new WorkStore({
    source: undefined,
    text: 'a',
    settings: { preset: 'balanced' },
    centreMm: undefined,
    centreIsGuess: false,
    batch: undefined,
  });
  changes = [];
  store.changed.on((work, before) => void changes.push([work.text, before.text]));
});

test('A change makes the next work and leaves the previous one', () => {
  const before = store.work;
  store.update({ text: 'b' });
  assert.equal(before.text, 'a');
  assert.equal(store.work.text, 'b');
  assert.equal(store.work.settings, before.settings);
  assert.deepEqual(changes, [['b', 'a']]);
});

test('A change can be computed from the work', () => {
  store.update(({ text }) => ({ text: `${text}${text}` }));
  assert.equal(store.work.text, 'aa');
});

test('An update without a difference tells nobody', () => {
  const before = store.work;
  store.update({ text: 'a', settings: before.settings });
  assert.equal(store.work, before);
  assert.deepEqual(changes, []);
});

test('A work is immutable', () => {
  const work = /** @type {any} */ (store.work);
  assert.throws(() => (work.text = 'b'), TypeError);
  assert.throws(() => (work.settings.preset = 'robust'), TypeError);
  store.update({ settings: { preset: 'robust' } });
  assert.throws(() => /** @type {any} */ (store.work.settings.preset = 'shallow'), TypeError);
});

test('A listener must not change the work; later changes still work', () => {
  let isEager = true;
  store.changed.on(() => {
    if (isEager) store.update({ text: 'c' });
  });
  assert.throws(() => store.update({ text: 'b' }), /must not change it/);
  isEager = false;
  store.update({ text: 'd' });
  assert.equal(store.work.text, 'd');
});
