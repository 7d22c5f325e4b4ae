// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { EngineFailure } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { messageWords } from '../i18n/message_words.js';
import { Batching, looksLikeList, plannedWords } from './batching.js';
import { FakeMessages, replaced, storeOf } from './testing.js';

const kInput = /** @type {any} */ ({
  from: 'list',
  list: new Uint8Array(4),
  listName: 'a.csv',
  count: 100,
  text: '',
  name: '',
  perPlate: 0,
});
const kPlan = { rows: 12, problems: [], mayBeMore: false, unused: [], warnings: [], version: 2, modules: 25 };

/** @type {any} */ let panel;
/** @type {import('./work_store.js').WorkStore} */ let store;
/** @type {any} */ let answer;
/** @type {any[]} */ let requests;
/** @type {any[]} */ let planned;
/** @type {FakeMessages} */ let messages;
let locked = false;
/** @type {Batching} */ let batching;

beforeEach(() => {
  panel = {
    show: () => {},
    takeList: (/** @type {any} */ list, /** @type {string} */ listName) => void (panel.taken = [list.length, listName]),
  };
  answer = kPlan;
  requests = [];
  planned = [];
  store = storeOf({ text: 'mine', settings: { preset: 'balanced' }, batch: kInput });
  locked = false;
  messages = new FakeMessages();
  batching = new Batching({
    client: /** @type {any} */ ({
      planBatch: async (/** @type {any} */ _, /** @type {any} */ asked) => {
        requests.push(asked);
        if (answer instanceof Error) throw answer;
        return answer;
      },
      batchRow: async () => ({
        number: 1,
        id: 'a',
        text: 'first',
        settings: { text: 'first', version: 2, pattern: 'square' },
      }),
      symbol: async (/** @type {any} */ { text }) => {
        if (text === '') throw new EngineFailure({ kind: 'BadInput', ...message('text-empty') });
      },
    }),
    panel,
    store,
    messages: /** @type {any} */ (messages),
    isLocked: () => locked,
  });
  batching.changed.on((now) => void planned.push(now));
});

test('Without a list there is one code', async () => {
  store.update({ batch: undefined });
  await batching.ready();
  assert.deepEqual([requests, planned, batching.incomplete], [[], [], false]);
  assert.deepEqual(batching.settings(), { text: 'mine', preset: 'balanced' });
});

test('The first part of a list is handled like a single code, with its values from the list', async () => {
  assert.equal(batching.incomplete, true);
  await batching.ready();
  assert.equal(batching.incomplete, false);
  assert.deepEqual(batching.settings(), { text: 'first', preset: 'balanced', pattern: 'square', version: 2 });
  assert.deepEqual(batching.decided, ['text', 'version', 'pattern']);
  assert.equal(plannedWords(planned[0]), '12 parts, version 2, 25 × 25 modules');
});

test('A list is planned again only if it or the settings change', async () => {
  await batching.ready();
  await batching.ready();
  assert.equal(requests.length, 1);
  store.update({ settings: { preset: 'robust' } });
  await batching.ready();
  store.update({ batch: { ...kInput, from: 'count', text: '{n}' } });
  await batching.ready();
  assert.deepEqual(
    requests.map(({ settings, text, count }) => [settings.preset, text, count]),
    [
      ['balanced', '', 0],
      ['robust', '', 0],
      ['robust', '{n}', 100],
    ],
  );
  batching.forget();
  await batching.ready();
  assert.equal(requests.length, 4);
});

test('A chosen column of ids, and whether the first row has names, belong to the request', async () => {
  await batching.ready();
  store.update({ batch: { ...kInput, id: 'Part', names: 'no' } });
  await batching.ready();
  store.update({ batch: { ...kInput, names: 'yes' } });
  await batching.ready();
  assert.deepEqual(
    requests.map(({ id, hasNames }) => [id, hasNames]),
    [
      [undefined, undefined],
      ['Part', false],
      [undefined, true],
    ],
  );
});

test('Reports the number of plates', async () => {
  store.update({ batch: { ...kInput, perPlate: 5 } });
  await batching.ready();
  assert.equal(plannedWords({ ...planned[0], plan: undefined }), '0 parts', 'texts alone have no version');
  assert.equal(plannedWords(planned[0]), '12 parts on 3 plates, version 2, 25 × 25 modules');
  assert.equal(requests[0].perPlate, 5);
});

test('A list with problems has no first part', async () => {
  answer = { ...kPlan, rows: 0, problems: [message('row-without-text'), message('row-without-id')], mayBeMore: true };
  await batching.ready();
  assert.equal(batching.incomplete, true);
  assert.equal(plannedWords(planned[0]), 'The list has 2 problems or more');
  assert.equal(batching.settings().text, ''); // not the text of the single code
  assert.equal(batching.missing?.(), 'The list has 2 problems or more.');
});

test('An unreadable list is a problem; a lost module is not', async () => {
  answer = new EngineFailure({ kind: 'BadInput', ...message('list-no-rows') });
  await batching.ready();
  assert.deepEqual(
    planned[0].problems.map((/** @type {any} */ { code }) => code),
    ['list-no-rows'],
  );
  assert.equal(plannedWords(planned[0]), 'The list has a problem');
  batching.forget();
  answer = replaced();
  await assert.rejects(batching.ready(), { code: 'engine-replaced' });
});

test('Without a list the module is not called', async () => {
  store.update({ batch: { ...kInput, list: new Uint8Array() } });
  await batching.ready();
  assert.deepEqual([requests.length, batching.incomplete], [0, true]);
  assert.equal(plannedWords(planned[0]), 'Open, drop or paste a list');
});

test('A list does not change while its parts are carved, and the page says why', async () => {
  locked = true;
  await batching.openList(new File(['text\nA\n'], 'b.csv'));
  assert.equal(panel.taken, undefined);
  assert.equal(messages.problem.found(), 'You can change the list once you discard its parts.');
  locked = false;
  await batching.openList(new File(['text\nA\n'], 'b.csv'));
  assert.deepEqual(panel.taken, [7, 'b.csv']);
});

test('A list that is too large is refused before it is read', async () => {
  await batching.openList(/** @type {any} */ ({ name: 'huge.csv', size: 1e9 }));
  assert.equal(
    messages.problem.found(),
    'huge.csv has\u00a0954\u00a0MiB; this page reads lists up to\u00a064\u00a0MiB',
  );
  assert.equal(panel.taken, undefined);
});

test('Lists are distinguished from models by name', () => {
  for (const name of ['a.csv', 'a.TSV', 'a.jsonl', 'a.ndjson', 'a.txt'])
    assert.equal(looksLikeList({ name, type: '' }), true, name);
  for (const name of ['a.stl', 'a.json', 'csv']) assert.equal(looksLikeList({ name, type: '' }), false, name);
});

test('Text or settings that make no code are explained in their own words', async () => {
  await messageWords.load();
  store.update({ batch: undefined, text: 'fine' });
  await batching.explainMissingCode();
  assert.deepEqual(messages.said, []);
  store.update({ text: '' });
  await batching.explainMissingCode();
  assert.deepEqual(messages.said, ['The text is empty.']);
});
