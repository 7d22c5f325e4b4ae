// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { message } from '../engine/message.js';
import { archiveContents } from './archive.js';
import { BatchStore, linesOf } from './batch_store.js';
import { RowStates } from './row_states.js';
import { FakeFolder } from './testing.js';

const kRecord = /** @type {any} */ ({
  work: { fileName: 'cube.stl', values: {} },
  rows: 4,
  printEvery: 10,
  wanted: { text: '' },
});
const lineOf = async (/** @type {any} */ entry) => JSON.stringify(entry);

/** @type {FakeFolder} */ let folder;
/** @type {BatchStore} */ let store;
const bytesOf = (/** @type {string} */ text) => new TextEncoder().encode(text);
const done = (/** @type {number} */ number, bytes = `model ${number}`) =>
  store.save(
    /** @type {any} */ ({
      rows: [{ entry: { number, file: `${number}.stl`, status: 'done' } }],
      file: `${number}.stl`,
      bytes: bytesOf(bytes),
    }),
    lineOf,
  );
const failed = (/** @type {number} */ number) =>
  store.save(
    /** @type {any} */ ({
      rows: [{ entry: { number, file: `${number}.stl`, status: 'failed' }, why: message('row-without-text') }],
      file: `${number}.stl`,
    }),
    lineOf,
  );
/** @param {AsyncGenerator<{ name: string, input: any }>} contents */
async function read(contents) {
  /** @type {Record<string, string>} */ const files = {};
  for await (const { name, input } of contents) {
    if (input instanceof File) files[name] = await input.text();
    else for await (const piece of input) files[name] = (files[name] ?? '') + piece;
  }
  return files;
}

beforeEach(() => {
  folder = new FakeFolder();
  store = new BatchStore(/** @type {any} */ (folder));
});

test('Restores the start of a batch and forgets the earlier batch', async () => {
  assert.equal(await store.recall(), undefined);
  await done(1);
  await store.begin(kRecord, { model: bytesOf('a cube'), list: bytesOf('text\nA\n') });
  const record = await store.recall();
  assert.deepEqual(record?.work, kRecord.work);
  assert.equal(record?.rows, 4);
  const { model, list } = await store.files();
  assert.deepEqual(
    [model, list].map((bytes) => new TextDecoder().decode(bytes)),
    ['a cube', 'text\nA\n'],
  );
  assert.equal(await store.file('1.stl'), undefined);
});

test('Ignores a batch of another version or a truncated one', async () => {
  await folder.append('batch.json', '{"format": 99}');
  assert.equal(await store.recall(), undefined);
  await folder.write('batch.json', bytesOf('{"format": 1, "wo'));
  assert.equal(await store.recall(), undefined);
});

test('The last line about a row counts; a truncated line is ignored', async () => {
  await failed(1);
  await done(2);
  await folder.append('manifest.jsonl', '{"number": 3, "status": "do');
  await failed(4);
  await done(1);
  const states = new RowStates(4);
  await store.readStates(states);
  assert.deepEqual(
    [0, 1, 2, 3].map((index) => states.of(index)),
    ['done', 'done', 'waiting', 'failed'],
  );
  assert.match(states.reasonOf(3), /^The text is empty/);
});

test('The archive has the files of done rows and both manifests in row order', async () => {
  await done(3);
  await failed(2);
  await done(1);
  await failed(3);
  await done(2, 'at last');
  /** @type {boolean[]} */ const headers = [];
  const client = {
    manifestCsv: async (/** @type {string} */ lines, /** @type {boolean} */ withHeader) => {
      headers.push(withHeader);
      return lines.replaceAll(/[{}"]/g, '');
    },
  };
  const files = await read(archiveContents(store, client));
  assert.deepEqual(Object.keys(files), ['manifest.jsonl', 'manifest.csv', '1.stl', '2.stl']);
  assert.equal(files['2.stl'], 'at last');
  const lines = files['manifest.jsonl']
    .trimEnd()
    .split('\n')
    .map((line) => JSON.parse(line));
  assert.deepEqual(
    lines.map(({ number, status }) => `${number} ${status}`),
    ['1 done', '2 done', '3 failed'],
  );
  assert.deepEqual(headers, [true]);
  assert.equal(files['manifest.csv'].split('\n').length, 4);
});

test('A plate of several rows is in the archive once', async () => {
  const rows = [1, 2].map((number) => ({ entry: { number, file: 'plate-001.3mf', status: 'done' } }));
  assert.deepEqual(
    await store.save(/** @type {any} */ ({ rows, file: 'plate-001.3mf', bytes: bytesOf('both') }), lineOf),
    ['', ''],
  );
  const files = await read(archiveContents(store, { manifestCsv: async () => '' }));
  assert.deepEqual(Object.keys(files), ['manifest.jsonl', 'manifest.csv', 'plate-001.3mf']);
  assert.equal(files['manifest.jsonl'].split('\n').length, 3);
});

test('Long manifests are read and written in pieces', async () => {
  for (let number = 1; number <= 450; number += 1)
    await folder.append('manifest.jsonl', JSON.stringify({ number, status: 'failed', text: 'ä'.repeat(300) }));
  /** @type {number[]} */ const pieces = [];
  const contents = archiveContents(store, { manifestCsv: async () => '' });
  const { value } = await contents.next();
  for await (const piece of /** @type {any} */ (value).input) pieces.push(piece.trimEnd().split('\n').length);
  assert.deepEqual(pieces, [200, 200, 50]);
});

test('A last line without a line ending counts', async () => {
  const lines = [];
  for await (const { text, begin, end } of linesOf(new Blob(['ä\n\nb']))) lines.push([text, begin, end]);
  assert.deepEqual(lines, [
    ['ä', 0, 2],
    ['', 3, 3],
    ['b', 4, 5],
  ]);
});
