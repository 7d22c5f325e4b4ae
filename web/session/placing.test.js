// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { afterEach, beforeEach, test } from 'node:test';
import { EngineClient } from '../engine/client.js';
import { EngineFailure } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { setLanguage } from '../i18n/catalogue.js';
import { messageWords } from '../i18n/message_words.js';
import { PlacePanel } from '../ui/place_panel.js';
import { Placing } from './placing.js';
import { FakeMessages, Pending, crashed, fake, noRoom, settled, storeOf } from './testing.js';
import { centredAt } from './work.js';

/** @typedef {import('./work.js').Point} Point */

/** @type {FakeMessages} */ let messages;
/** @type {any} */ let client;
/** @type {any} */ let panel;
/** @type {any} */ let model;
/** @type {import('./work_store.js').WorkStore} */ let store;
/** @type {{ incomplete: boolean, incompleteWords: string }} */ let code;
/** @type {any} */ let batching;
/** @type {Placing} */ let placing;
const problem = () => /** @type {any} */ (messages.problem);
let mayMove = true;
let moved = 0;

beforeEach(() => {
  messages = new FakeMessages();
  panel = fake(PlacePanel);
  client = fake(EngineClient, {
    placement: async () => ({ symbolMm: 20 }),
    setCentre: async (/** @type {{ mm: number[] }} */ { mm }) => ({ hit: true, centre: mm }),
  });
  model = { info: { engravable: true, centre: [1, 2, 3], findings: [] }, engravable: true };
  store = storeOf();
  mayMove = true;
  moved = 0;
  code = { incomplete: false, incompleteWords: 'Fill in the fields' };
  batching = { plannedSettings: async () => ({}), missing: undefined };
  placing = new Placing({
    client,
    model,
    store,
    messages: /** @type {any} */ (messages),
    panel,
    batching,
    code,
    jobs: {
      get busy() {
        return !mayMove;
      },
    },
    guard: (action) => action().then(() => {}),
  });
  placing.moved.on(() => void (moved += 1));
});
afterEach(() => setLanguage('en'));

test('After a search without a spot only the panel says why: the status refers to it, and no error repeats it', async () => {
  await placing.move(async () => ({ hit: true, centre: /** @type {Point} */ ([0, 0, 0]) }));
  messages.showError(message('code-too-large-here'));
  placing.explain({ kind: 'NoSolution', ...message('no-spot-so-large') });
  assert.equal(messages.said.at(-1), 'The code has no spot yet: “Place” says why.');
  assert.equal(problem(), undefined);
  assert.match(panel.calls.at(-1) ?? '', /^explain/);
});

test('An incomplete text takes the code off the model; the status says so, and the fields say what is missing', async () => {
  await placing.begin();
  await placing.propose({ spot: 0 });
  placing.confirmCentre();
  client.answers.placement = async () => {
    throw new EngineFailure({ kind: 'BadUsage', ...message('text-empty') });
  };
  code.incomplete = true;
  await placing.place(true);
  assert.equal(placing.placement, undefined);
  assert.equal(messages.said.at(-1), 'Fill in the fields.');
  batching.missing = () => 'The list has a problem.';
  await placing.place();
  assert.equal(messages.said.at(-1), 'The list has a problem.');
  assert.equal(problem(), undefined);
});

test('After a search without a spot the view asks for no click', () => {
  /** @type {boolean[]} */ const announced = [];
  placing.placed.on(() => announced.push(placing.isHopeless));
  placing.explain({ kind: 'NoSolution', code: 'nothing-can-be-carved', values: { wall: { lengthMm: 0.8 } } });
  assert.deepEqual(announced, [true]); // the view's own request for a click disappears
});

test('A model without a centre starts at the module’s proposal', async () => {
  await placing.begin();
  assert.deepEqual(store.work.centreMm, [1, 2, 3]);
  assert.equal(store.work.centreIsGuess, true);
  assert.equal(placing.placement?.symbolMm, 20);
  assert.equal(moved, 0);
  assert.equal(messages.said.at(-1), 'Ready.');
});

test('A proposed centre without room asks for another; a chosen one is an error', async () => {
  client.answers.placement = async () => {
    throw noRoom();
  };
  await placing.begin();
  assert.equal(problem(), undefined);
  assert.match(messages.said.at(-1) ?? '', /Click the model/);
  await placing.move(async () => ({ hit: true, centre: /** @type {Point} */ ([0, 0, 0]) }));
  assert.equal(problem().code, 'no-centre');
  assert.equal(placing.placement, undefined);
  assert.equal(moved, 1);
});

test('A model that is too small for any code says so at its proposed centre, and asks for no other', async () => {
  client.answers.placement = async () => {
    throw noRoom();
  };
  await placing.begin();
  assert.deepEqual([placing.lacksRoom, placing.isHopeless], [true, false]);
  client.answers.placement = async () => {
    const most = { lengthMm: 2.94 };
    throw new EngineFailure({ kind: 'NoSolution', ...message('model-too-small', { most }) });
  };
  await placing.begin();
  assert.deepEqual([placing.lacksRoom, placing.isHopeless], [true, true]);
  assert.match(panel.calls.at(-1) ?? '', /^explain/);
  assert.match(messages.said.at(-1) ?? '', /“Place” says why/);
  assert.equal(problem(), undefined);
});

test('The view asks for a spot unless a click does not help', async () => {
  assert.equal(placing.asksForSpot, true);
  client.answers.placement = async () => {
    throw noRoom();
  };
  await placing.begin();
  assert.equal(placing.asksForSpot, true);
  client.answers.configure = async () => {
    throw new EngineFailure({ kind: 'BadUsage', ...message('text-empty') });
  };
  await placing.place();
  assert.equal(placing.asksForSpot, false);
});

test('A code that was moved off an edge says so', async () => {
  await placing.move(async () => ({ hit: true, centre: /** @type {Point} */ ([4, 0, 0]), movedMm: 3.25 }));
  assert.match(messages.said.at(-1) ?? '', /moved by 3\.\d+\smm/);
  assert.deepEqual(store.work.centreMm, [4, 0, 0]);
});

test('A centre that is undone while its code is being placed is not said to be moved off an edge', async () => {
  const configured = new Pending();
  client.answers.configure = () => configured.promise;
  const moving = placing.move(async () => ({ hit: true, centre: /** @type {Point} */ ([4, 0, 0]), movedMm: 3.25 }));
  await settled();
  await placing.restoreCentre([1, 0, 0], false);
  const undone = placing.place();
  configured.resolve();
  await Promise.all([moving, undone]);
  assert.equal(messages.said.at(-1), 'Ready.');
});

test('A proposed centre is the user’s only once chosen', async () => {
  client.answers.setCentre = async () => ({ hit: true, centre: [7, 8, 9] });
  await placing.propose({ spot: 0 });
  assert.deepEqual(store.work.centreMm, [7, 8, 9]);
  assert.equal(store.work.centreIsGuess, true);
  assert.equal(moved, 0);
  assert.equal(placing.placement?.symbolMm, 20);
});

test('Insisting on the proposal reports the error', async () => {
  await placing.begin();
  placing.confirmCentre();
  client.answers.placement = async () => {
    throw noRoom();
  };
  await placing.place();
  assert.equal(problem().code, 'no-centre');
});

test('A picked centre is waited for until it has taken effect', async () => {
  const picked = new Pending();
  const move = placing.move(() => picked.promise);
  const { moving } = placing;
  picked.resolve({ hit: true, centre: [4, 0, 0] });
  await moving;
  assert.deepEqual(store.work.centreMm, [4, 0, 0]);
  await move;
  assert.equal(placing.moving, undefined);
  await assert.rejects(placing.move(() => Promise.reject(new Error('lost'))));
  assert.equal(placing.moving, undefined);
});

test('A silent placing changes the status only for an error, or if a placing that is not silent follows', async () => {
  store.update(centredAt([0, 0, 0]));
  messages.say(() => 'Choose a spot.');
  await placing.place(true);
  assert.equal(messages.said.at(-1), 'Choose a spot.');
  const first = new Pending();
  client.answers.placement = () => first.promise;
  const all = [placing.place(true)];
  await settled();
  all.push(placing.place(), placing.place(true));
  first.resolve({ symbolMm: 20 });
  await Promise.all(all);
  assert.equal(messages.said.at(-1), 'Ready.');
  client.answers.placement = async () => {
    throw noRoom();
  };
  await placing.place(true);
  assert.equal(problem().code, 'no-centre');
  assert.doesNotMatch(messages.said.at(-1) ?? '', /Ready/);
});

test('A request during a run causes one more run, with the newest settings', async () => {
  store.update(centredAt([0, 0, 0]));
  const first = new Pending();
  client.answers.placement = () => first.promise;
  const all = [placing.place()];
  await settled();
  all.push(placing.place(), placing.place());
  client.answers.placement = async () => ({ symbolMm: 30 });
  first.resolve({ symbolMm: 20 });
  await Promise.all(all);
  assert.deepEqual(client.calls.filter((/** @type {string} */ call) => call === 'placement').length, 2);
  assert.equal(placing.placement?.symbolMm, 30);
  assert.equal(messages.said.filter((said) => said === 'Ready.').length, 1, 'said only of the newest');
});

test('An error is not shown if a newer request follows', async () => {
  store.update(centredAt([0, 0, 0]));
  const first = new Pending();
  client.answers.placement = () => first.promise;
  const all = [placing.place()];
  await settled();
  all.push(placing.place());
  client.answers.placement = async () => ({ symbolMm: 30 });
  first.reject(noRoom());
  await Promise.all(all);
  assert.equal(problem(), undefined);
});

test('A model that cannot be engraved says why, in the chosen language', async () => {
  model.engravable = false;
  model.info = {
    engravable: false,
    findings: [
      { severity: 'note', ...message('untold', { text: { term: 'a note' } }) },
      { severity: 'blocking', ...message('no-such-spot', { index: { count: 7 } }) },
      { severity: 'blocking', ...message('no-such-spot', { index: { count: 8 } }) },
    ],
  };
  await messageWords.load();
  await placing.begin();
  assert.equal(problem().found(), 'The spot index 7 is out of range. The spot index 8 is out of range.');
  await setLanguage('de');
  await messageWords.load();
  assert.equal(problem().found(), 'Der Index 7 einer Stelle ist zu groß. Der Index 8 einer Stelle ist zu groß.');
});

test('Nothing moves during a job or beside the model', async () => {
  store.update(centredAt([0, 0, 0]));
  mayMove = false;
  await placing.move(async () => ({ hit: true, centre: /** @type {Point} */ ([9, 9, 9]) }));
  mayMove = true;
  await placing.move(async () => ({ hit: false }));
  assert.deepEqual(store.work.centreMm, [0, 0, 0]);
  assert.equal(moved, 0);
});

test('A broken module is left for others to replace', async () => {
  store.update(centredAt([0, 0, 0]));
  client.answers.placement = async () => {
    throw crashed();
  };
  await assert.rejects(placing.place(), { code: 'engine-crashed' });
});

test('Placing the code again withdraws the “Ready” message at once', async () => {
  store.update(centredAt([0, 0, 0]));
  await placing.place();
  assert.equal(messages.said.at(-1), 'Ready.');
  const configured = new Pending();
  client.answers.configure = () => configured.promise;
  const placed = placing.place();
  assert.match(messages.said.at(-1) ?? '', /^Finding direction/);
  configured.resolve();
  await placed;
  assert.equal(messages.said.at(-1), 'Ready.');
});
