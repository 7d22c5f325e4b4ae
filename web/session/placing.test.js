// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { afterEach, beforeEach, test } from 'node:test';
import { message } from '../engine/message.js';
import { setLanguage } from '../i18n/catalogue.js';
import { messageWords } from '../i18n/message_words.js';
import { Centre } from './centre.js';
import { Placing } from './placing.js';
import { FakeMessages, Pending, crashed, fake, noRoom, settled } from './testing.js';

/** @typedef {import('./centre.js').Point} Point */

/** @type {FakeMessages} */ let messages;
/** @type {any} */ let client;
/** @type {any} */ let model;
/** @type {Centre} */ let centre;
/** @type {Placing} */ let placing;
const problem = () => /** @type {any} */ (messages.problem);
let mayMove = true;
let moved = 0;

beforeEach(() => {
  messages = new FakeMessages();
  client = fake({
    placement: async () => ({ symbolMm: 20 }),
    setCentre: async (/** @type {{ mm: number[] }} */ { mm }) => ({ hit: true, centre: mm }),
  });
  model = { info: { engravable: true, centre: [1, 2, 3], findings: [] }, engravable: true };
  centre = new Centre(() => {});
  mayMove = true;
  moved = 0;
  placing = new Placing({
    client,
    model,
    centre,
    messages: /** @type {any} */ (messages),
    panel: fake(),
    settings: () => /** @type {any} */ ({}),
    mayMove: () => mayMove,
    onMoved: () => void (moved += 1),
    onPlaced: () => {},
  });
});
afterEach(() => setLanguage('en'));

test('Without a centre of its own a model begins at the one that the module proposes', async () => {
  await placing.begin();
  assert.deepEqual(centre.mm, [1, 2, 3]);
  assert.equal(centre.isGuess, true);
  assert.equal(placing.placement?.symbolMm, 20);
  assert.equal(moved, 0);
  assert.equal(messages.said.at(-1), 'Ready.');
});

test('A proposal where the code has no place asks for another; a choice there is an error', async () => {
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

test('Who insists on the proposal hears of the error, too', async () => {
  await placing.begin();
  placing.insist();
  client.answers.placement = async () => {
    throw noRoom();
  };
  await placing.place();
  assert.equal(problem().code, 'no-centre');
});

test('Asked again while it runs, it runs once more, with the newest settings', async () => {
  centre.put([0, 0, 0]);
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

test('An error that a newer request follows is not shown', async () => {
  centre.put([0, 0, 0]);
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

test('A model that cannot be engraved says why, in the language chosen', async () => {
  model.engravable = false;
  model.info = {
    engravable: false,
    findings: [
      { severity: 'note', ...message('untold', { text: { term: 'a note' } }) },
      { severity: 'blocking', ...message('no-such-spot', { index: { count: 7 } }) },
    ],
  };
  await messageWords.come();
  await placing.begin();
  assert.equal(problem().found(), 'There is no spot 7');
  setLanguage('de');
  await messageWords.come();
  assert.equal(problem().found(), 'Es gibt keine Stelle 7');
});

test('While something is at work, and beside the model, nothing moves', async () => {
  centre.put([0, 0, 0]);
  mayMove = false;
  await placing.move(async () => ({ hit: true, centre: /** @type {Point} */ ([9, 9, 9]) }));
  mayMove = true;
  await placing.move(async () => ({ hit: false }));
  assert.deepEqual(centre.mm, [0, 0, 0]);
  assert.equal(moved, 0);
});

test('A module that is beyond use is for others to replace', async () => {
  centre.put([0, 0, 0]);
  client.answers.placement = async () => {
    throw crashed();
  };
  await assert.rejects(placing.place(), { code: 'engine-crashed' });
});

test('From the moment that the code is placed anew the page is not said to be ready', async () => {
  centre.put([0, 0, 0]);
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
