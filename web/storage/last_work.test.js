// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { LastWork, kMaxBytes } from './last_work.js';

/** Stores copies, like IndexedDB, and counts the bytes written. */
class MemoryStore {
  constructor() {
    /** @type {Map<string, any>} */ this.values = new Map();
    this.full = false;
    this.bytesWritten = 0;
  }

  /** @param {string} key */
  async get(key) {
    return structuredClone(this.values.get(key));
  }

  /** @param {Record<string, any>} values */
  async put(values) {
    for (const [key, value] of Object.entries(values)) {
      if (value !== undefined && this.full) return false;
      this.bytesWritten += value?.bytes?.length ?? 0;
      if (value === undefined) this.values.delete(key);
      else this.values.set(key, structuredClone(value));
    }
    return true;
  }
}

const noSecrets = () => false;
const opened = {
  fileName: 'bunny.stl',
  sampleId: 'bunny',
  scaleToMm: 1,
  upAxis: /** @type {const} */ ('z'),
  text: 'a',
  settings: { preset: /** @type {const} */ ('balanced') },
};
const own = () => ({
  fileName: 'cup.stl',
  bytes: Uint8Array.of(1, 2, 3),
  scaleToMm: 25.4,
  upAxis: /** @type {const} */ ('y'),
  text: 'b',
  settings: { preset: /** @type {const} */ ('robust'), quietZone: true },
  centreMm: /** @type {[number, number, number]} */ ([1, 2, 3]),
});

/**
 * Opens the page, with a sample unless `start` is false.
 * @param {{ store?: MemoryStore, isSecret?: (text: string) => boolean, start?: boolean }} [visited]
 */
function visit({ store = new MemoryStore(), isSecret = noSecrets, start = true } = {}) {
  const last = new LastWork(store, isSecret);
  last.openedWith(start ? opened : undefined);
  return { store, last };
}

/** @param {LastWork} last @param {import('./last_work.js').Work} work */
async function keep(last, work) {
  last.save(work);
  await last.flush();
}

test('the opening state is not kept, changes are', async () => {
  const { store, last } = visit();
  await keep(last, opened);
  assert.equal(await last.recall(), undefined);
  await keep(last, { ...opened, text: 'other' });
  assert.deepEqual(await new LastWork(store, noSecrets).recall(), { ...opened, text: 'other' });
});

test('a choice before the page has opened anything is kept', async () => {
  const { last } = visit({ start: false });
  await keep(last, opened);
  assert.deepEqual(await last.recall(), opened);
});

test('a file is restored with bytes, unit, axis, text, settings and centre', async () => {
  const { store, last } = visit();
  const work = own();
  await keep(last, work);
  assert.deepEqual(await new LastWork(store, noSecrets).recall(), work);
});

test('a change of settings does not write the file again', async () => {
  const { store, last } = visit();
  const work = own();
  await keep(last, work);
  await keep(last, { ...work, text: 'c' });
  assert.equal(store.bytesWritten, 3);
  assert.deepEqual(await last.recall(), { ...work, text: 'c' });
});

test('only the last of several quick changes is written', async () => {
  const { store, last } = visit();
  for (const text of ['b', 'bc', 'bcd']) last.save({ ...opened, text });
  assert.equal(store.values.size, 0);
  await last.flush();
  assert.equal((await last.recall())?.text, 'bcd');
});

test('another file of the same name and size replaces the first', async () => {
  const { last } = visit();
  await keep(last, own());
  await keep(last, { ...own(), bytes: Uint8Array.of(4, 5, 6) });
  assert.deepEqual((await last.recall())?.bytes, Uint8Array.of(4, 5, 6));
});

test('a text with a password is never written, the rest is', async () => {
  const { store, last } = visit({ isSecret: (text) => text.startsWith('WIFI:') });
  await keep(last, { ...opened, text: 'WIFI:T:WPA;S:net;P:secret;;', settings: { preset: 'robust' } });
  assert.doesNotMatch(JSON.stringify([...store.values]), /secret/);
  const { text: _, ...rest } = opened;
  assert.deepEqual(await last.recall(), { ...rest, settings: { preset: 'robust' } });
});

test('a full storage keeps nothing instead of half, and the earlier work is not offered', async () => {
  const { store, last } = visit();
  await keep(last, { ...opened, text: 'before' });
  store.full = true;
  await keep(last, own());
  assert.equal(await last.recall(), undefined);
  assert.equal(store.values.size, 0);
});

test('a file above the size limit is not kept', async () => {
  const { last } = visit();
  const bytes = /** @type {Uint8Array} */ ({ length: kMaxBytes + 1 });
  await keep(last, { ...own(), bytes });
  assert.equal(await last.recall(), undefined);
});

test('a file is not mixed with settings from another window', async () => {
  const { store, last } = visit();
  await keep(last, own());
  store.values.get('last model').id += 1;
  assert.equal(await last.recall(), undefined);
});

test('discarded work is not offered', async () => {
  const { last } = visit();
  await keep(last, own());
  await last.forget();
  assert.equal(await last.recall(), undefined);
});

test('discarding the last visit’s work keeps the work of this visit', async () => {
  const { store, last: before } = visit();
  await keep(before, own());

  const { last: next } = visit({ store });
  await keep(next, { ...opened, text: 'new' });
  await next.discard();
  assert.equal((await next.recall())?.text, 'new');

  const { last: later } = visit({ store });
  await later.discard();
  assert.equal(await later.recall(), undefined);
});

/** @param {string} list */
const batchOf = (list) => ({
  from: /** @type {const} */ ('list'),
  list: new TextEncoder().encode(list),
  listName: 'parts.csv',
  count: 100,
  text: '',
  name: '{id}.3mf',
  perPlate: 0,
  id: '',
  names: /** @type {const} */ (''),
});

test('the list of a batch is restored; another list of the same length replaces it', async () => {
  const { store, last } = visit();
  await keep(last, { ...opened, batch: batchOf('text\nA\n') });
  await keep(last, { ...opened, batch: batchOf('text\nB\n') });
  assert.deepEqual(await new LastWork(store, noSecrets).recall(), { ...opened, batch: batchOf('text\nB\n') });
});

test('a list with a secret in a text is not kept', async () => {
  const { last } = visit({ isSecret: (text) => /^\s*WIFI:/.test(text) });
  for (const list of ['text\nWIFI:S:a;P:b;;\n', 'id,text\n1,WIFI:S:a;P:b;;\n', '{"text": "WIFI:S:a;P:b;;"}\n']) {
    await keep(last, { ...opened, batch: batchOf(list) });
    assert.equal((await last.recall())?.batch, undefined, list);
  }
  await keep(last, { ...opened, batch: { ...batchOf('pass\nb\n'), text: 'WIFI:S:a;P:{pass};;' } });
  assert.equal((await last.recall())?.batch, undefined);
});
