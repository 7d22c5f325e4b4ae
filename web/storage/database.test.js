// SPDX-License-Identifier: GPL-3.0-or-later
// e2e/autosave.spec.js tests a real IndexedDB.
import assert from 'node:assert/strict';
import { afterEach, test } from 'node:test';
import { holdsSecret } from '../payloads/secrets.js';
import { Database } from './database.js';
import { LastWork } from './last_work.js';

const before = Object.getOwnPropertyDescriptor(globalThis, 'indexedDB');
afterEach(() => {
  if (before) Object.defineProperty(globalThis, 'indexedDB', before);
  else delete (/** @type {any} */ (globalThis).indexedDB);
});

test('Without browser storage nothing is kept, silently', async () => {
  Object.defineProperty(globalThis, 'indexedDB', {
    configurable: true,
    get: () => {
      throw new DOMException('denied', 'SecurityError');
    },
  });
  const database = new Database();
  assert.equal(await database.put({ a: 1 }), false);
  assert.equal(await database.get('a'), undefined);
  const last = new LastWork(database, holdsSecret);
  last.openedWith(undefined);
  last.save({ fileName: 'bunny.stl', sampleId: 'bunny', scaleToMm: 1, upAxis: 'z', text: 'a', settings: {} });
  await last.flush();
  assert.equal(await last.recall(), undefined);
});

test('The password of a network is not stored', async () => {
  /** @type {any[]} */ const written = [];
  const store = { get: async () => undefined, put: async (/** @type {any} */ values) => written.push(values) > 0 };
  const last = new LastWork(store, holdsSecret);
  last.openedWith(undefined);
  last.save({
    fileName: 'bunny.stl',
    sampleId: 'bunny',
    scaleToMm: 1,
    upAxis: 'z',
    text: 'WIFI:T:WPA;S:home;P:very secret;;',
    settings: {},
  });
  await last.flush();
  assert.ok(written.length > 0);
  assert.doesNotMatch(JSON.stringify(written), /very secret/);
});
