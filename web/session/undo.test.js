// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { after, beforeEach, test } from 'node:test';
import { Carving } from './carving.js';
import { Autosave } from './autosave.js';
import { ModelSession } from './model_session.js';
import { Placing } from './placing.js';
import { Signal } from './signal.js';
import { SpotSearch } from './spot_search.js';
import { FakeMessages, Pending, fake, settled, storeOf } from './testing.js';
import { Undo } from './undo.js';
import { centredAt, chosenCentre } from './work.js';

class FakeElement extends EventTarget {
  disabled = false;
  title = '';
  /** @type {Record<string, string>} */ dataset = {};
  removeAttribute() {
    this.title = '';
  }
}
const {
  document: realDocument,
  HTMLElement: realElement,
  HTMLButtonElement: realButton,
  HTMLFormElement: realForm,
} = globalThis;
/** @type {Record<string, FakeElement>} */ let elements;

/** @type {any} */ let model;
/** @type {any} */ let placing;
/** @type {any} */ let carving;
/** @type {FakeMessages} */ let messages;
/** @type {import('./work_store.js').WorkStore} */ let store;
let busy = false;
/** @type {Undo} */ let undo;
/** @type {any} */ let spots;

beforeEach(() => {
  elements = { undo: new FakeElement(), redo: new FakeElement(), panel: new FakeElement() };
  Object.assign(globalThis, {
    document: { getElementById: (/** @type {string} */ id) => elements[id] },
    HTMLElement: FakeElement,
    HTMLButtonElement: FakeElement,
    HTMLFormElement: FakeElement,
  });
  busy = false;
  store = storeOf({
    source: /** @type {any} */ ({ bytes: new Uint8Array([1]), scaleToMm: 1, upAxis: 'z' }),
    text: 'a',
    settings: { preset: 'balanced' },
  });
  store.update(centredAt([1, 0, 0]));
  model = fake(ModelSession, {
    load: async (/** @type {any} */ source, /** @type {any} */ centreMm) =>
      store.update({ source, ...centredAt(centreMm) }),
  });
  placing = fake(
    Placing,
    {
      restoreCentre: async (/** @type {any} */ mm, /** @type {boolean} */ isGuess) =>
        store.update(centredAt(mm, isGuess)),
    },
    { proposed: new Signal(), moving: undefined },
  );
  carving = fake(
    Carving,
    {
      restore: async (/** @type {any} */ carved) => {
        carving.latest = carved;
        return carved !== undefined;
      },
    },
    { latest: undefined, finished: new Signal() },
  );
  messages = new FakeMessages();
  spots = fake(SpotSearch);
  undo = new Undo({
    model,
    placing,
    carving,
    spots,
    messages: /** @type {any} */ (messages),
    jobs: /** @type {any} */ ({
      get busy() {
        return busy;
      },
    }),
    store,
    editor: { restore: ({ text, settings }) => store.update({ text, settings }) },
    autosave: fake(Autosave),
    guard: (action) => action().then(() => {}),
  });
  undo.record();
});
after(() => {
  Object.assign(globalThis, {
    document: realDocument,
    HTMLElement: realElement,
    HTMLButtonElement: realButton,
    HTMLFormElement: realForm,
  });
});

test('A text is undone and redone, and the code placed again', async () => {
  store.update({ text: 'b' });
  undo.record('text');
  undo.undo();
  await settled();
  assert.equal(store.work.text, 'a');
  assert.deepEqual(placing.calls, ['place']);
  assert.deepEqual(spots.calls, ['forget']);
  undo.redo();
  await settled();
  assert.equal(store.work.text, 'b');
});

test('Undo restores a centre and whether it was proposed', async () => {
  store.update(centredAt([2, 0, 0]));
  undo.record('centre');
  undo.undo();
  await settled();
  assert.deepEqual(chosenCentre(store.work), [1, 0, 0]);
  assert.deepEqual(model.calls, []);
  assert.deepEqual(spots.calls, ['unmark'], 'the suggested spots stay');
});

test('An undo while a picked centre is not known yet undoes that pick alone', async () => {
  store.update({ text: 'b' });
  undo.record('text');
  const picked = new Pending();
  placing.moving = picked.promise;
  elements.undo.dispatchEvent(new Event('click'));
  store.update(centredAt([2, 0, 0]));
  undo.record('centre');
  placing.moving = undefined;
  picked.resolve();
  await settled();
  assert.deepEqual([store.work.text, store.work.centreMm], ['b', [1, 0, 0]]);
});

test('A proposed spot is nothing to undo', async () => {
  store.update({ text: 'b' });
  undo.record('text');
  store.update(centredAt([5, 0, 0], true));
  placing.proposed.emit();
  store.update({ text: 'c' });
  undo.record('other');
  undo.undo();
  await settled();
  assert.deepEqual([store.work.text, store.work.centreMm], ['b', [5, 0, 0]]);
  undo.undo();
  await settled();
  assert.equal(store.work.text, 'a');
});

test('Undo reloads the previous model with its chosen centre', async () => {
  const before = store.work.source;
  const source = /** @type {any} */ ({ bytes: new Uint8Array([2]), scaleToMm: 1, upAxis: 'z' });
  store.update({ source, ...centredAt([9, 9, 9], true) });
  undo.record();
  undo.undo();
  await settled();
  assert.equal(store.work.source, before);
  assert.deepEqual(chosenCentre(store.work), [1, 0, 0]);
});

test('A carving is restored if the module still has it; else a message says so', async () => {
  carving.latest = { number: 1 };
  undo.record();
  carving.latest = { number: 2 };
  undo.record();
  undo.undo();
  await settled();
  assert.equal(carving.latest.number, 1);
  assert.deepEqual(messages.said, []);
  carving.answers.restore = async () => false;
  undo.redo();
  await settled();
  assert.equal(messages.said.length, 1);
});

test('Combined changes are undone together', async () => {
  await undo.asOne(async () => {
    store.update({ text: 'b' });
    undo.record('text');
    store.update({ settings: { preset: 'robust' } });
    undo.record('preset');
  });
  undo.undo();
  await settled();
  assert.deepEqual([store.work.text, store.work.settings], ['a', { preset: 'balanced' }]);
});

test('A state replaced during another change can be restored', async () => {
  const placed = new Pending();
  const loading = undo.asOne(async () => {
    store.update({ text: 'b' });
    await placed.promise;
  });
  undo.recordNow();
  const startingOver = undo.asOne(async () => {
    store.update({ text: 'fresh' });
    await placed.promise;
  });
  placed.resolve();
  await Promise.all([loading, startingOver]);
  undo.undo();
  await settled();
  assert.equal(store.work.text, 'b');
});

test('The buttons are disabled during jobs', () => {
  store.update({ text: 'b' });
  undo.record();
  assert.equal(elements.undo.disabled, false);
  assert.equal(elements.undo.title, '');
  busy = true;
  undo.updateButtons();
  assert.equal(elements.undo.disabled, true);
  assert.match(elements.undo.title, /^Wait until/);
});

/** Makes texts b, c and d, and holds back the restoring of the first state. */
const restoringHeld = () => {
  for (const text of ['b', 'c', 'd']) {
    store.update({ text });
    undo.record();
  }
  const placed = new Pending();
  placing.answers.place = () => placed.promise;
  elements.undo.dispatchEvent(new Event('click'));
  return placed;
};

test('Steps pressed while a state is restored are counted, and taken together after it', async () => {
  const placed = restoringHeld();
  assert.equal(store.work.text, 'c');
  for (const press of ['undo', 'undo', 'undo', 'redo']) elements[press].dispatchEvent(new Event('click'));
  assert.deepEqual([elements.undo.disabled, elements.redo.disabled], [false, false]);
  elements.undo.dispatchEvent(new Event('click'));
  assert.deepEqual([elements.undo.disabled, elements.redo.disabled], [true, false], 'the first state is reached');
  placed.resolve();
  await settled();
  assert.equal(store.work.text, 'a');
  assert.equal(placing.calls.length, 2, 'no state between is restored');
  assert.deepEqual([elements.undo.disabled, elements.redo.disabled], [true, false]);
});

test('An edit or a job that comes while a state is restored is newer than the steps counted before', async () => {
  const placed = restoringHeld();
  elements.undo.dispatchEvent(new Event('click'));
  busy = true;
  placed.resolve();
  await settled();
  assert.equal(store.work.text, 'c');
  busy = false;
  undo.redo();
  undo.undo();
  store.update({ text: 'e' });
  elements.panel.dispatchEvent(new Event('input'));
  await settled();
  assert.equal(store.work.text, 'e');
});

test('An edit while a state is being restored can be undone by itself', async () => {
  undo.record();
  store.update({ text: 'b' });
  undo.record();
  const placed = new Pending();
  placing.answers.place = () => placed.promise;
  undo.undo();
  store.update({ text: 'c' });
  elements.panel.dispatchEvent(new Event('input'));
  placed.resolve(undefined);
  await settled();
  placing.answers.place = async () => {};
  undo.undo();
  await settled();
  assert.equal(store.work.text, 'a');
});
