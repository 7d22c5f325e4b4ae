// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { Batching } from './batching.js';
import { WorkEditor } from './work_editor.js';
import { ModelSession } from './model_session.js';
import { Placing } from './placing.js';
import { Signal } from './signal.js';
import { SpotSearch } from './spot_search.js';
import { FakeMessages, fake, settled, storeOf } from './testing.js';

/** @type {import('../settings/work_settings.js').WorkSettings} */
const kDefaults = {
  preset: 'balanced',
  mark: 'shadow',
  process: 'none',
  nozzleMm: 0.4,
  layerMm: 0.2,
  size: 'best',
  maxSizeMm: 40,
  rotateDeg: 0,
  buildUp: 'as-modelled',
};
const kBatch = /** @type {any} */ ({ from: 'count', count: 3 });

/** A panel whose user a test plays with `user`. */
class FakePanel {
  /** @type {any} */ user;
  /** @type {any[]} */ shown = [];
  /** @param {any} listener */
  listen(listener) {
    this.user = listener;
  }
  refresh() {}
  showParts() {}
  /** @param {any} placement */
  showPlaced(placement) {
    this.shown.push(placement);
  }
}

/** @type {import('./work_store.js').WorkStore} */ let store;
/** @type {FakePanel} */ let form;
/** @type {FakePanel} */ let code;
/** @type {FakePanel} */ let batchPanel;
/** @type {(change: import('../engine/types.js').SettingChange, label: string) => void} */ let remedy;
/** @type {any} */ let model;
/** @type {any} */ let batching;
/** @type {any} */ let spots;
/** @type {any} */ let placing;
/** @type {FakeMessages} */ let messages;
/** @type {(string | undefined)[]} */ let applied;
/** @type {WorkEditor} */ let editor;

beforeEach(() => {
  store = storeOf({ text: 'a', settings: kDefaults });
  applied = [];
  store.applied.on((field) => void applied.push(field));
  [form, code, batchPanel] = [new FakePanel(), new FakePanel(), new FakePanel()];
  model = fake(ModelSession);
  batching = fake(Batching, { ready: async () => {}, isLocked: false }, { changed: new Signal() });
  spots = fake(SpotSearch);
  placing = fake(Placing, {}, { placed: new Signal(), placement: { symbolMm: 20 } });
  messages = new FakeMessages();
  editor = new WorkEditor({
    store,
    defaults: kDefaults,
    form,
    code,
    batchPanel,
    placePanel: { listenToRemedies: (listener) => void (remedy = listener) },
    model,
    batching,
    spots,
    placing,
    messages: /** @type {any} */ (messages),
    guard: async (action) => void (await action()),
  });
});

test('Each letter changes the work; a pause applies the text', async () => {
  code.user.onInput('ab');
  assert.equal(store.work.text, 'ab');
  assert.deepEqual([applied, placing.calls], [[], []]);
  await code.user.onChange();
  assert.deepEqual([applied, placing.calls], [['text'], ['place']]);
});

test('An incomplete text is placed in vain, but is no edit to undo', async () => {
  await code.user.onIncomplete();
  assert.deepEqual([applied, placing.calls], [[], ['place true']]);
});

test('A change that helps at the place is made', async () => {
  remedy({ setting: 'mark', value: 'paint' }, 'Paint it instead');
  await settled();
  assert.equal(store.work.settings.mark, 'paint');
  assert.equal(messages.said.at(-1), 'Paint it instead: set “Made by” to Second colour, painted.'); // nothing was engraved yet
});

test('Once a change is applied, a best spot is proposed again', async () => {
  await code.user.onChange();
  assert.deepEqual(spots.calls, ['forget', 'proposeAgain']);
});

test('A complete edit of a setting changes its dependent settings', async () => {
  form.user.onInput({ process: 'resin-0.05' });
  assert.deepEqual([store.work.settings.process, store.work.settings.nozzleMm], ['resin-0.05', 0.4]);
  await form.user.onChange({ process: 'resin-0.05' });
  assert.deepEqual([store.work.settings.nozzleMm, store.work.settings.layerMm], [0.05, 0.05]);
  assert.deepEqual(applied, ['process']);
});

test('The handles set the size and drop the suggested spots', async () => {
  await editor.adjust({ symbolMm: 21.5 });
  assert.deepEqual([store.work.settings.size, store.work.settings.maxSizeMm], [21.5, 40]);
  assert.deepEqual([applied, spots.calls, placing.calls], [['size'], ['forget', 'proposeAgain'], ['place']]);
});

test('A code that was turned to fit keeps its turn when it is resized', async () => {
  placing.placement = { symbolMm: 30, rotationDeg: 36.43 };
  await editor.adjust({ symbolMm: 21.5 });
  assert.deepEqual([store.work.settings.size, store.work.settings.rotateDeg], [21.5, 36.4]);
  await editor.adjust({ rotateDeg: 0 });
  assert.equal(store.work.settings.rotateDeg, 0);
});

test('A list changes the work before it is planned', async () => {
  /** @type {any} */ let planned;
  batching.answers.ready = async () => void (planned ??= store.work.batch);
  await batchPanel.user.onChange(kBatch);
  assert.equal(planned, kBatch);
  assert.deepEqual(applied, ['parts']);
});

test('A remedy changes its settings and reports it; a remedy without a setting suggests spots', async () => {
  const deeper = /** @type {any} */ ({ changes: [{ setting: 'preset', value: 'robust' }] });
  let said = 0;
  messages.say = () => void (said += 1);
  await editor.remedy(deeper, 'Carve deeper');
  assert.deepEqual([store.work.settings.preset, said], ['robust', 1]);
  const both = [
    { setting: 'nozzleMm', value: '0.15' },
    { setting: 'layerMm', value: '0.1' },
  ];
  await editor.remedy({ changes: both }, 'Print finer');
  const { nozzleMm, layerMm } = store.work.settings;
  assert.deepEqual([nozzleMm, layerMm, said, applied.length], [0.15, 0.1, 2, 2], 'both in one step');
  placing.placement = undefined;
  await editor.remedy({ ...deeper, changes: [{ setting: 'preset', value: 'shallow' }] }, 'Carve shallower');
  assert.deepEqual([store.work.settings.preset, said], ['shallow', 2]);
  await editor.remedy({ ...deeper, changes: undefined }, 'Find a spot');
  assert.equal(spots.calls.at(-1), 'suggest');
  assert.deepEqual([applied.length, said], [3, 2]);
});

test('Restoring a work does not apply it, and keeps a list whose parts are carved', () => {
  editor.restore({ text: 'b', settings: { preset: 'robust' }, batch: kBatch });
  assert.deepEqual(store.work.settings, { ...kDefaults, preset: 'robust' });
  assert.deepEqual([store.work.text, store.work.batch, applied], ['b', kBatch, []]);
  batching.answers.isLocked = true;
  editor.restore({ text: 'c', settings: {}, batch: undefined });
  assert.deepEqual([store.work.text, store.work.batch], ['c', kBatch]);
});

test('A stored work restores its sample or file, and keeps the current text if it has none', async () => {
  /** @type {any[]} */ const opened = [];
  model.answers.openSample = async (/** @type {any[]} */ ...options) => void opened.push(options);
  model.answers.load = async (/** @type {any[]} */ ...options) => void opened.push(options);
  const place = { fileName: 'a.stl', scaleToMm: 1, upAxis: /** @type {const} */ ('z') };
  await editor.continueWith({ ...place, sampleId: 'saddle', settings: {}, centreMm: [1, 2, 3] });
  assert.equal(store.work.text, 'a');
  const bytes = new Uint8Array([1]);
  await editor.continueWith({ ...place, bytes, text: 'b', settings: {}, centreMm: [4, 5, 6] });
  assert.equal(store.work.text, 'b');
  assert.deepEqual(opened, [
    ['saddle', { ...place, centreMm: [1, 2, 3] }],
    [{ ...place, bytes, credit: '' }, [4, 5, 6]],
  ]);
});

test('The code panel shows the placement', () => {
  placing.placed.emit({ symbolMm: 20 });
  placing.placed.emit(undefined);
  assert.deepEqual(code.shown, [{ symbolMm: 20 }, undefined]);
});

test('An edit removes an error only if there is a model, and says why there is no code', async () => {
  const problem = { found: () => 'There is no sample “foo”', help: () => '' };
  messages.showError(problem);
  await editor.apply('text');
  assert.equal(messages.problem, problem);
  model.answers.engravable = true;
  placing.placement = undefined;
  await editor.apply('text');
  assert.equal(messages.problem, undefined);
  assert.ok(batching.calls.includes('explainMissingCode'));
});

test('A carved model that becomes the model stands as it is printed', async () => {
  store.update(({ settings }) => ({ settings: { ...settings, buildUp: 'code-up' } }));
  /** @type {unknown} */ let loaded;
  model.answers.load = async (/** @type {unknown} */ source) => {
    loaded = source;
  };
  const carved = /** @type {any} */ ({ fileName: 'carved.3mf' });
  await editor.goOnWith(carved);
  assert.equal(loaded, carved);
  assert.equal(store.work.settings.buildUp, 'as-modelled');
});
