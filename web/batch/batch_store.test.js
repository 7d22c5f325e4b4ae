// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { message } from '../engine/message.js';
import { archiveContents } from './archive.js';
import { BatchStore, readManifest } from './batch_store.js';
import { FakeFolder } from './testing.js';

const kRecord = /** @type {any} */ ({
  work: { fileName: 'cube.stl', settings: {} },
  rows: 4,
  printEvery: 10,
  request: { text: '' },
});
const lineOf = (/** @type {any} */ entry) => JSON.stringify(entry);

/** @type {FakeFolder} */ let folder;
/** @type {BatchStore} */ let store;
const bytesOf = (/** @type {string} */ text) => new TextEncoder().encode(text);
const done = (/** @type {number} */ number, bytes = `model ${number}`) =>
  store.save(
    /** @type {any} */ ({
      rows: [{ entry: { number, file: `${number}.stl`, status: 'done' } }],
      files: [{ name: `${number}.stl`, bytes: bytesOf(bytes) }],
    }),
    lineOf,
  );
const failed = (/** @type {number} */ number) =>
  store.save(
    /** @type {any} */ ({
      rows: [{ entry: { number, file: `${number}.stl`, status: 'failed' }, why: message('row-without-text') }],
      files: [],
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

test('Restores a batch of version 1, which called the request `wanted`', async () => {
  await folder.write('batch.json', bytesOf('{"format": 1, "rows": 4, "wanted": {"text": "A"}}'));
  assert.deepEqual((await store.recall())?.request, { text: 'A' });
});

test('Ignores a batch of another version or a truncated one', async () => {
  await folder.append('batch.json', '{"format": 99}');
  assert.equal(await store.recall(), undefined);
  await folder.write('batch.json', bytesOf('{"format": 1, "wo'));
  assert.equal(await store.recall(), undefined);
});

/** A tracker that knows only the numbers of the rows. */
class FakeReader {
  text = '';
  /** @type {boolean[]} */ restored = [];
  /** @param {number[]} numbers  in order */
  constructor(numbers) {
    this.numbers = numbers;
  }
  /** @param {Uint8Array} bytes @param {boolean} isFirst @param {boolean} restores */
  readManifest(bytes, isFirst, restores) {
    this.text = (isFirst ? '' : this.text) + new TextDecoder().decode(bytes);
    this.restored.push(restores);
  }
  /** @param {number} from @param {number} count @returns {{ spans: [number, number][], next: number | null }} */
  manifestSpans(from, count) {
    const left = this.numbers.filter((number) => number >= from);
    return {
      spans: left.slice(0, count).map((number) => {
        const begin = this.text.lastIndexOf(`{"number":${number},`);
        return [begin, this.text.indexOf('\n', begin)];
      }),
      next: left[count] ?? null,
    };
  }
  manifestCsv() {
    return '';
  }
}

test('Saving a row returns its manifest line, with the reason of a failure in words', async () => {
  const line = await failed(4);
  assert.match(JSON.parse(line).reason, /^The text is empty/);
  assert.equal(await (await store.manifest()).text(), `${line}\n`);
});

test('The manifest is read in pieces, after an earlier one is forgotten', async () => {
  const tracker = new FakeReader([]);
  tracker.text = 'of another batch';
  await readManifest(await store.manifest(), tracker, { restores: true });
  assert.equal(tracker.text, '');
  await done(1);
  await readManifest(await store.manifest(), tracker, { restores: true });
  assert.equal(tracker.text, await (await store.snapshot()).text());
  assert.ok(tracker.restored.every(Boolean));
});

test('The archive has the files of done rows and both manifests in row order', async () => {
  await done(3);
  await failed(2);
  await done(1);
  await failed(3);
  await done(2, 'at last');
  /** @type {boolean[]} */ const headers = [];
  const tracker = Object.assign(new FakeReader([1, 2, 3]), {
    manifestCsv: (/** @type {string} */ lines, /** @type {boolean} */ withHeader) => {
      headers.push(withHeader);
      return lines.replaceAll(/[{}"]/g, '');
    },
  });
  const files = await read(archiveContents(store, tracker));
  assert.ok(!tracker.restored.some(Boolean), 'a download changes no states');
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
  const plate = [{ name: 'plate-001.3mf', bytes: bytesOf('both') }];
  const lines = await store.save(/** @type {any} */ ({ rows, files: plate }), lineOf);
  assert.equal(lines.split('\n').length, 2);
  const files = await read(archiveContents(store, new FakeReader([1, 2])));
  assert.deepEqual(Object.keys(files), ['manifest.jsonl', 'manifest.csv', 'plate-001.3mf']);
  assert.equal(files['manifest.jsonl'].split('\n').length, 3);
});

test('A second file of a row is in the archive after its first one', async () => {
  await done(2);
  const files = ['1.stl', '1-2.stl'].map((name) => ({ name, bytes: bytesOf(name) }));
  const entry = { number: 1, file: '1.stl', second: '1-2.stl', status: 'done' };
  await store.save(/** @type {any} */ ({ rows: [{ entry }], files }), lineOf);
  const saved = await read(archiveContents(store, new FakeReader([1, 2])));
  assert.deepEqual(Object.keys(saved), ['manifest.jsonl', 'manifest.csv', '1.stl', '1-2.stl', '2.stl']);
  assert.equal(saved['1-2.stl'], '1-2.stl');
});

test('Long manifests are written in pieces', async () => {
  const numbers = Array.from({ length: 450 }, (_, i) => i + 1);
  for (const number of numbers) await folder.append('manifest.jsonl', JSON.stringify({ number, status: 'failed' }));
  /** @type {number[]} */ const pieces = [];
  const { value } = await archiveContents(store, new FakeReader(numbers)).next();
  for await (const piece of /** @type {any} */ (value).input) pieces.push(piece.trimEnd().split('\n').length);
  assert.deepEqual(pieces, [200, 200, 50]);
});
