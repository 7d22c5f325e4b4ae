// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { CodePanel } from '../ui/code_panel.js';
import { ModelPanel } from '../ui/model_panel.js';
import { Batching } from './batching.js';
import { WorkEditor } from './work_editor.js';
import { Exporter } from './exporter.js';
import { Jobs } from './jobs.js';
import { ModelSession } from './model_session.js';
import { FileOpener } from './file_opener.js';
import { FakeMessages, Pending, fake, settled, storeOf } from './testing.js';
import { Undo } from './undo.js';

/** @type {any} */ let parts;
/** @type {string[]} */ let opened;
/** @type {any} */ let restored;
/** @type {import('../ui/model_panel.js').ModelListener} */ let listener;
/** @type {FileOpener} */ let opener;

beforeEach(() => {
  opened = [];
  restored = undefined;
  const opens = (/** @type {string} */ kind) => async () => void opened.push(kind);
  parts = {
    panel: fake(ModelPanel, { listen: (/** @type {any} */ to) => void (listener = to) }),
    code: fake(CodePanel, {}, { initialText: 'first' }),
    defaults: { preset: 'balanced' },
    store: storeOf({ text: 'of the sample' }),
    model: fake(ModelSession, { source: {}, openFile: opens('model'), openSample: opens('sample') }),
    batching: fake(Batching, { openList: opens('list') }),
    editor: fake(WorkEditor, { restore: (/** @type {any} */ state) => void (restored = state) }),
    exporter: fake(Exporter, { useSettings: opens('settings') }, { asked: {} }),
    undo: fake(Undo, { asOne: (/** @type {() => Promise<void>} */ action) => action() }),
    jobs: fake(Jobs),
    messages: new FakeMessages(),
    guard: (/** @type {() => Promise<unknown>} */ action) => action(),
  };
  opener = new FileOpener(parts);
  opener.started = Promise.resolve(true);
});

test('The name of a file decides how it is opened', async () => {
  for (const name of ['a.stl', 'a.csv', 'a.json']) await opener.openFile(new File([''], name));
  assert.deepEqual(opened, ['model', 'list', 'settings']);
});

test('A JSON file with an array is a list, after a byte order mark and spaces, too', async () => {
  for (const json of ['[{"id": "A1"}]', '\ufeff\n ["https://example.org"]', '{"kind": "qrelief-settings"}'])
    await opener.openFile(new File([json], 'a.json'));
  assert.deepEqual(opened, ['list', 'list', 'settings']);
});

test('Settings and lists without a model open the first sample', async () => {
  parts.model.answers.source = undefined;
  for (const name of ['a.json', 'a.csv']) await opener.openFile(new File([''], name));
  assert.deepEqual(opened, ['sample', 'settings', 'sample', 'list']);
});

test('An early file waits for the module; without a module it is not opened', async () => {
  const started = new Pending();
  opener.started = started.promise;
  const opens = opener.openFile(new File([''], 'a.stl'));
  assert.equal(opener.fileChosen, true);
  await settled();
  assert.deepEqual(opened, []);
  started.resolve(true);
  await opens;
  assert.deepEqual(opened, ['model']);
  opener.started = Promise.resolve(false);
  await opener.openFile(new File([''], 'b.stl'));
  assert.deepEqual(opened, ['model']);
});

test('A text that came with a sample does not follow to the user’s model, any other text does', async () => {
  const open = async () => {
    await opener.openFile(new File([''], 'a.stl'));
    return parts.store.work.text;
  };
  assert.equal(await open(), 'of the sample', 'the address gave the text to no sample');
  opener.sampleText = 'of the sample';
  parts.store.update({ text: 'typed' });
  assert.equal(await open(), 'typed');
  parts.store.update({ text: 'of the sample' });
  assert.equal(await open(), 'first');
  assert.deepEqual(parts.editor.calls, ['apply text']);
});

test('Starting over restores the first text and the defaults as one change', async () => {
  await opener.startOver();
  assert.deepEqual(restored, { text: 'first', settings: { preset: 'balanced' }, batch: undefined });
  assert.deepEqual(opened, ['sample']);
  assert.deepEqual(parts.undo.calls, ['recordNow', 'asOne']);
  assert.deepEqual(parts.code.calls, ['leaveBuilder']);
});

test('A size made for one model does not follow to the user’s next model or sample, unless a link asked for it', async () => {
  /** @type {any[]} */ const sizes = [];
  const takes = (/** @type {any[]} */ ...given) => void sizes.push(given.at(-1)({ size: 15, rotateDeg: 0 }).size);
  Object.assign(parts.model.answers, { openFile: takes, openSample: takes });
  const open = async () => {
    await opener.openFile(new File([''], 'a.stl'));
    await listener.onSample('vase');
  };
  await open();
  parts.exporter.asked = { size: 15, rotateDeg: 0 };
  await open();
  assert.deepEqual(sizes, ['best', 'best', 15, 15]);
});

test('Of several dropped files one is opened, and the page says so', async () => {
  await listener.onFile(new File([''], 'a.stl'), 0);
  assert.equal(parts.messages.problem, undefined);
  await listener.onFile(new File([''], 'a.obj'), 2);
  assert.deepEqual(opened, ['model', 'model']);
  assert.equal(parts.messages.problem.found(), 'Of the 3 files, only a.obj was opened');
});
