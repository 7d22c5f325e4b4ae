// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { EngineClient } from '../engine/client.js';
import { CodePanel } from '../ui/code_panel.js';
import { SpotsPanel } from '../ui/spots_panel.js';
import { WorkPanel } from '../ui/work_panel.js';
import { Carving } from './carving.js';
import { Jobs } from './jobs.js';
import { Placing } from './placing.js';
import { Signal } from './signal.js';
import { SpotSearch } from './spot_search.js';
import { FakeMessages, Pending, fake, noRoom, settled, storeOf } from './testing.js';
import { centredAt } from './work.js';

const kFound = { spots: [{ centre: [1, 2, 3], sizeMm: 20, aimToleranceDeg: 30, concerns: [] }], topMm: 20 };

/** @type {any} */ let client;
/** @type {any} */ let model;
/** @type {any} */ let placing;
/** @type {any} */ let panel;
/** @type {FakeMessages} */ let messages;
/** @type {Jobs} */ let jobs;
/** @type {import('./work_store.js').WorkStore} */ let store;
/** @type {SpotSearch} */ let spots;
/** @type {Pending} */ let search;
/** @type {Pending} */ let shown; // the carving's answer
/** @type {AbortSignal | undefined} */ let signal;

beforeEach(() => {
  search = new Pending();
  shown = new Pending();
  client = fake(EngineClient, {
    findSpots: (/** @type {{ signal: AbortSignal }} */ options) => {
      signal = options.signal;
      return search.promise;
    },
    act: async () => {},
    configure: async () => {},
    show: async () => ({}),
    spotPicture: async () => ({ width: 0, height: 0, pixels: new Uint8Array() }),
  });
  model = { info: {}, engravable: true };
  store = storeOf(centredAt([0, 0, 0], true));
  const placed = async () => messages.say(() => 'Ready.');
  placing = fake(Placing, { propose: placed, place: placed }, { moved: new Signal(), placement: undefined });
  panel = fake(SpotsPanel, { known: true });
  messages = new FakeMessages();
  const said = /** @type {any} */ (messages);
  jobs = new Jobs({ panel: fake(WorkPanel), messages: said, onBusy: () => {} });
  spots = new SpotSearch({
    ...{ client, jobs, store, model, placing, messages: said, panel },
    batching: { settings: () => /** @type {any} */ ({}), plannedSettings: async () => /** @type {any} */ ({}) },
    carving: fake(Carving, { show: () => shown.promise }, { started: new Signal() }),
    code: fake(CodePanel, { settle: async () => {} }),
    guard: async (action) => void (await action()),
  });
});

test('The best spot of a new model is proposed, without the colours of the sizes', async () => {
  spots.begin();
  await settled();
  assert.equal(jobs.busy, false);
  assert.match(messages.said.at(-1) ?? '', /spot/);
  search.resolve(kFound);
  await spots.proposed;
  assert.deepEqual(placing.calls, ['propose']);
  assert.ok(panel.calls.includes('show false'));
  assert.deepEqual(
    client.calls,
    ['configure', 'findSpots', 'act', 'spotPicture 0 126 84'].slice(0, client.calls.length),
  );
});

test('A place that the user has chosen stays', async () => {
  store.update(centredAt([0, 0, 0]));
  spots.begin();
  await spots.proposed;
  assert.deepEqual([client.calls, placing.calls], [[], []]);
});

test('A click during the search ends it', async () => {
  spots.begin();
  await settled();
  placing.moved.emit();
  messages.say(() => 'Ready.');
  assert.equal(signal?.aborted, true);
  search.resolve(undefined);
  await spots.proposed;
  assert.deepEqual(placing.calls, []);
  spots.proposeAgain();
  assert.deepEqual(client.calls, ['configure', 'findSpots']);
});

test('A search that is no longer wanted is not said to go on', async () => {
  spots.begin();
  await settled();
  store.update(centredAt([0, 0, 0]));
  await spots.forget();
  search.resolve(undefined);
  await spots.proposed;
  assert.deepEqual(placing.calls, ['place']);
});

test('A change of settings during the search begins it again, once', async () => {
  spots.begin();
  await settled();
  await spots.forget();
  assert.equal(signal?.aborted, true);
  const first = search;
  search = new Pending();
  first.resolve(undefined);
  spots.proposeAgain();
  await settled();
  search.resolve(kFound);
  await spots.proposed;
  assert.deepEqual(placing.calls.filter((/** @type {string} */ call) => call === 'propose').length, 1);
  spots.proposeAgain();
  await settled();
  assert.deepEqual(client.calls.filter((/** @type {string} */ call) => call === 'findSpots').length, 2);
});

test('Two edits during the search leave one search, whose best spot is proposed', async () => {
  spots.begin();
  await settled();
  await spots.forget();
  await spots.forget();
  const first = search;
  search = new Pending();
  first.resolve(undefined);
  spots.proposeAgain();
  spots.proposeAgain();
  await settled();
  search.resolve(kFound);
  await spots.proposed;
  await settled();
  assert.deepEqual(
    client.calls.filter((/** @type {string} */ call) => call === 'findSpots' || call === 'act'),
    ['findSpots', 'findSpots', 'act'],
  );
  assert.ok(panel.calls.includes('mark 0'));
});

test('An edit while the best spot is being placed proposes the best spot for the newest settings', async () => {
  const placed = new Pending();
  placing.answers.propose = () => placed.promise;
  spots.begin();
  search.resolve(kFound);
  await settled();
  await spots.forget();
  spots.proposeAgain();
  placing.answers.propose = async () => messages.say(() => 'Ready.');
  placed.resolve();
  await spots.proposed;
  assert.deepEqual(placing.calls, ['propose', 'place', 'propose']);
  assert.equal(panel.calls.filter((/** @type {string} */ call) => call === 'mark 0').length, 1);
});

test('A model opened during the search gets its own proposal', async () => {
  spots.begin();
  await settled();
  const first = search;
  search = new Pending();
  model.info = {};
  spots.begin();
  first.resolve(kFound);
  await settled();
  search.resolve(kFound);
  await spots.proposed;
  assert.deepEqual(placing.calls, ['place', 'propose']);
});

test('A spot whose choice was undone meanwhile is not marked', async () => {
  client.answers.setCentre = async () => ({ hit: true, centre: [1, 2, 3] });
  placing.answers.move = async (/** @type {() => Promise<any>} */ pick) =>
    store.update(centredAt((await pick()).centre));
  const marked = () => panel.calls.filter((/** @type {string} */ call) => call === 'mark 0').length;
  await spots.choose(0);
  assert.equal(marked(), 1);
  placing.answers.move = async (/** @type {() => Promise<any>} */ pick) => void (await pick());
  store.update(centredAt([0, 0, 0]));
  await spots.choose(0);
  assert.equal(marked(), 1);
});

test('A model without a spot keeps the first proposal', async () => {
  placing.placement = { symbolMm: 20 };
  spots.begin();
  await settled();
  search.reject(noRoom());
  await spots.proposed;
  assert.deepEqual(placing.calls, ['place']);
});

test('Without a complete text or list no spots are searched, and the status says what is missing', async () => {
  placing.answers.missing = () => () => 'Open, drop or paste a list.';
  await spots.suggest();
  assert.equal(messages.said.at(-1), 'Open, drop or paste a list.');
  assert.deepEqual(client.calls, []);
});

test('A cancelled search says so while the module is still busy', async () => {
  const suggested = spots.suggest();
  await settled();
  jobs.cancel();
  search.resolve(undefined);
  await suggested;
  assert.equal(messages.said.at(-1), 'Cancelled.');
});

test('A model without a spot or a fitting proposal says why', async () => {
  /** @type {any} */ let problem;
  placing.answers.explain = (/** @type {any} */ said) => void (problem = said);
  spots.begin();
  await settled();
  search.reject(noRoom());
  await spots.proposed;
  assert.deepEqual([placing.calls[0], problem.code], ['place', 'no-centre']);
});

test('Settings for which the proposed spot has no room begin a search; without a spot the page says why', async () => {
  spots.begin();
  search.resolve(kFound);
  await spots.proposed;
  placing.calls.length = 0;
  placing.answers.lacksRoom = true;
  search = new Pending();
  spots.proposeAgain();
  await settled();
  search.reject(noRoom());
  await spots.proposed;
  assert.deepEqual(placing.calls, ['place', 'explain']);
});

test('A size without room at the chosen centre offers spots with room for it, and says if there are none', async () => {
  store.update(centredAt([4, 5, 6]));
  placing.answers.isTooLarge = true;
  spots.proposeAgain();
  await settled();
  search.resolve(kFound);
  await spots.proposed;
  assert.deepEqual(placing.calls, []); // the code stays where the user wants it
  assert.ok(panel.calls.includes('show false'));
  assert.equal(messages.said.at(-1), 'Choose a spot, or click the model.');

  search = new Pending();
  spots.proposeAgain();
  await settled();
  search.reject(noRoom());
  await spots.proposed;
  assert.deepEqual(placing.calls, ['explain']);
});
