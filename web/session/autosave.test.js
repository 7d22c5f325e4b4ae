// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { after, beforeEach, test } from 'node:test';
import { LastWork } from '../storage/last_work.js';
import { Notices } from '../ui/notices.js';
import { Autosave } from './autosave.js';
import { WorkEditor } from './work_editor.js';
import { fake, storeOf } from './testing.js';

const { document: realDocument, location: realLocation } = globalThis;
/** @type {any} */ let saved;
/** @type {any} */ let last;
/** @type {any} */ let notices;
/** @type {import('./work_store.js').WorkStore} */ let store;
/** @type {EventTarget & { visibilityState?: string }} */ let page;
/** @type {Autosave} */ let autosave;

beforeEach(() => {
  page = new EventTarget();
  Object.assign(globalThis, { document: page, location: { search: '?sample=vase' } });
  saved = [];
  last = fake(LastWork, {
    save: (/** @type {any} */ work) => void saved.push(work),
    recall: async () => ({ sampleId: 'vase', fileName: 'vase.stl', address: '?sample=vase', text: 'kept' }),
  });
  notices = fake(Notices);
  store = storeOf({ source: /** @type {any} */ ({ sampleId: 'vase', fileName: 'vase.stl' }), text: 'a' });
  autosave = new Autosave({ last, notices, store, editor: fake(WorkEditor), guard: async () => {} });
});
after(() => void Object.assign(globalThis, { document: realDocument, location: realLocation }));

test('Every typed letter is saved with the address, and kept at once when the page is hidden', async () => {
  store.update({ text: 'b' });
  assert.equal(saved.length, 0, 'not before the page has opened its model');
  await autosave.begin('never');
  store.update({ text: 'bc' });
  assert.deepEqual([saved.at(-1).text, saved.at(-1).address], ['bc', '?sample=vase']);
  page.visibilityState = 'hidden';
  page.dispatchEvent(new Event('visibilitychange'));
  assert.equal(last.calls.at(-1), 'flush');
});

test('The last work is offered, at an address that asks for something only if it was done there', async () => {
  const offers = () => notices.calls.filter((/** @type {string} */ call) => call.startsWith('show')).length;
  await autosave.begin('never');
  assert.equal(offers(), 0);
  await autosave.begin('always');
  assert.equal(offers(), 1);
  assert.match(notices.calls.at(-1), /Continue with Vase\?/);
  await autosave.begin('same-address');
  assert.equal(offers(), 2);
  location.search = '?sample=vase&engrave=1';
  await autosave.begin('same-address');
  assert.equal(offers(), 2);
  await autosave.begin('always');
  assert.equal(offers(), 3);
});
