// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { EngineClient } from '../engine/client.js';
import { ModelPanel } from '../ui/model_panel.js';
import { WorkPanel } from '../ui/work_panel.js';
import { Jobs } from './jobs.js';
import { ModelSession } from './model_session.js';
import { FakeMessages, fake, noRoom, storeOf } from './testing.js';
import { centredAt, chosenCentre } from './work.js';

/** @type {FakeMessages} */ let messages;
/** @type {any} */ let client;
/** @type {any} */ let panel;
/** @type {import('./work_store.js').WorkStore} */ let store;
/** @type {ModelSession} */ let model;
/** @type {string[]} */ let events;

/** @type {import('./model_session.js').Source} */
const kSource = { bytes: new Uint8Array([1]), fileName: 'a.stl', scaleToMm: 1, upAxis: 'z', credit: '' };

beforeEach(() => {
  messages = new FakeMessages();
  client = fake(EngineClient, {
    loadModel: async (/** @type {Uint8Array} */ _, /** @type {string} */ __, /** @type {number} */ scaleToMm) => ({
      engravable: true,
      scaleToMm: scaleToMm || 25.4,
      findings: [],
    }),
  });
  panel = fake(ModelPanel, { scaleToMm: 1 });
  store = storeOf();
  events = [];
  model = new ModelSession({
    client,
    panel,
    store,
    messages: /** @type {any} */ (messages),
    jobs: new Jobs({ panel: fake(WorkPanel), messages: /** @type {any} */ (messages), onBusy: () => {} }),
    onReplacing: () => void events.push('replacing'),
    onLoaded: async () => void events.push('loaded'),
    onFailed: () => void events.push('failed'),
  });
});

test('A model is set once it is read, with its centre', async () => {
  await model.load(kSource, [1, 2, 3]);
  assert.deepEqual(events, ['replacing', 'loaded']);
  assert.equal(model.source?.fileName, 'a.stl');
  assert.deepEqual(chosenCentre(store.work), [1, 2, 3]);
});

test('An unreadable file keeps the previous model, its centre and its up axis', async () => {
  await model.load(kSource, [1, 2, 3]);
  client.answers.loadModel = async () => {
    throw noRoom();
  };
  /** @type {string[]} */ const axes = [];
  client.answers.show = async (/** @type {any} */ { upAxis }) => void axes.push(upAxis);
  await assert.rejects(model.load({ ...kSource, fileName: 'b.stl', upAxis: 'y' }), { code: 'no-centre' });
  assert.equal(model.source?.fileName, 'a.stl');
  assert.deepEqual(chosenCentre(store.work), [1, 2, 3]);
  assert.deepEqual(axes, ['y', 'z']);
  assert.equal(events.at(-1), 'failed');
});

test('In another unit the centre keeps its position on the model, even after moves and undos', async () => {
  await model.load(kSource, [1, 2, 3]);
  store.update(centredAt([4, 5, 6]));
  await model.rescale(10);
  assert.deepEqual(chosenCentre(store.work), [40, 50, 60]);
  store.update(centredAt([7, 7, 7], true));
  await model.rescale(1);
  assert.equal(store.work.centreMm, undefined); // a proposal is not kept
});

test('The unit of the file replaces an unknown one', async () => {
  await model.load({ ...kSource, scaleToMm: 0 });
  assert.equal(model.source?.scaleToMm, 25.4);
  assert.equal(model.source?.unitStated, true);
});

test('A 3MF and a ZIP, which may hold one, bring their unit; other files have the unit of the panel', async () => {
  for (const name of ['a.3mf', 'a.ZIP']) {
    await model.openFile(new File(['x'], name));
    assert.equal(model.source?.unitStated, true, name);
  }
  await model.openFile(new File(['x'], 'a.stl'));
  assert.equal(model.source?.unitStated, false);
});

test('An unknown sample is named with the known ones, and nothing is read', async () => {
  const sample = {
    name: 'A',
    file: 'a.stl',
    centreMm: /** @type {[number, number, number]} */ ([0, 0, 0]),
    credit: '',
  };
  model.setSamples([
    { ...sample, id: 'bunny' },
    { ...sample, id: 'vase' },
  ]);
  await model.openSample('teapot');
  assert.match(messages.problem.found(), /There is no sample “teapot”/);
  assert.match(messages.problem.help(), /bunny, vase/);
  assert.equal(messages.said.at(-1), 'Choose a model.');
  assert.deepEqual(events, []);
  assert.equal(model.source, undefined);
});

test('A sample that cannot be fetched is named with its remedy, and the model stays', async (context) => {
  await model.load(kSource);
  model.setSamples([{ id: 'vase', name: 'Vase', file: 'vase.stl', centreMm: [0, 0, 0], credit: '' }]);
  context.mock.method(globalThis, 'fetch', () => Promise.reject(new TypeError('Failed to fetch')));
  await model.openSample('vase');
  assert.equal(messages.problem.found(), 'The sample “Vase” could not be loaded');
  assert.match(messages.problem.help(), /^Check your connection/);
  assert.equal(model.source?.fileName, 'a.stl');
});

test('A new model starts with settings made for it, unless it cannot be read', async () => {
  store.update({ settings: { size: 24.6 } });
  const opens = () =>
    model.openFile(new File([''], 'b.stl'), ({ size: _, ...others }) => ({ ...others, size: 'best' }));
  const { loadModel } = client.answers;
  client.answers.loadModel = async () => {
    throw noRoom();
  };
  await assert.rejects(opens());
  assert.deepEqual(store.work.settings, { size: 24.6 });
  client.answers.loadModel = loadModel;
  await opens();
  assert.deepEqual(store.work.settings, { size: 'best' });
});
