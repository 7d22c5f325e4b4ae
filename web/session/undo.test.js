// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { after, beforeEach, test } from 'node:test';
import { EngineClient } from '../engine/client.js';
import { Carving } from './carving.js';
import { Centre } from './centre.js';
import { ModelSession } from './model_session.js';
import { Placing } from './placing.js';
import { SpotFinding } from './spot_finding.js';
import { FakeMessages, Pending, fake, settled } from './testing.js';
import { Undo } from './undo.js';

class FakeElement extends EventTarget {
  disabled = false;
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
/** @type {Centre} */ let centre;
/** @type {{ text: string, values: Record<string, string> }} */ let controls;
let busy = false;
/** @type {Undo} */ let undo;

beforeEach(() => {
  elements = { undo: new FakeElement(), redo: new FakeElement(), panel: new FakeElement() };
  Object.assign(globalThis, {
    document: { getElementById: (/** @type {string} */ id) => elements[id] },
    HTMLElement: FakeElement,
    HTMLButtonElement: FakeElement,
    HTMLFormElement: FakeElement,
  });
  busy = false;
  controls = { text: 'a', values: { preset: 'balanced' } };
  centre = new Centre(() => {});
  centre.put([1, 0, 0]);
  model = fake(
    ModelSession,
    {
      load: async (/** @type {any} */ source, /** @type {any} */ centreMm) => {
        model.source = source;
        centre.put(centreMm);
      },
    },
    { source: { bytes: new Uint8Array([1]), scaleToMm: 1, upAxis: 'z' } },
  );
  placing = fake(Placing, {
    put: async (/** @type {any} */ mm, /** @type {boolean} */ isGuess) => centre.put(mm, isGuess),
  });
  carving = fake(
    Carving,
    {
      restore: async (/** @type {any} */ carved) => {
        carving.carved = carved;
        return carved !== undefined;
      },
    },
    { carved: undefined },
  );
  messages = new FakeMessages();
  undo = new Undo({
    client: fake(EngineClient),
    model,
    placing,
    carving,
    spots: fake(SpotFinding),
    messages: /** @type {any} */ (messages),
    jobs: /** @type {any} */ ({
      get busy() {
        return busy;
      },
    }),
    work: () =>
      /** @type {any} */ ({ source: model.source, ...controls, centreMm: centre.mm, centreIsGuess: centre.isGuess }),
    write: ({ text, values }) => void (controls = /** @type {any} */ ({ text, values })),
    guard: (action) => action().then(() => {}),
    onRestored: () => {},
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
  controls = { ...controls, text: 'b' };
  undo.record('text');
  undo.undo();
  await settled();
  assert.equal(controls.text, 'a');
  assert.deepEqual(placing.calls, ['place']);
  undo.redo();
  await settled();
  assert.equal(controls.text, 'b');
});

test('Undo restores a centre and whether it was proposed', async () => {
  centre.put([2, 0, 0]);
  undo.record('centre');
  undo.undo();
  await settled();
  assert.deepEqual(centre.chosenMm, [1, 0, 0]);
  assert.deepEqual(model.calls, []);
});

test('Undo reloads the previous model with its chosen centre', async () => {
  const before = model.source;
  model.source = { bytes: new Uint8Array([2]), scaleToMm: 1, upAxis: 'z' };
  centre.put([9, 9, 9], true);
  undo.record();
  undo.undo();
  await settled();
  assert.equal(model.source, before);
  assert.deepEqual(centre.chosenMm, [1, 0, 0]);
});

test('A carving is restored if the module still has it; else a message says so', async () => {
  carving.carved = { number: 1 };
  undo.record();
  carving.carved = { number: 2 };
  undo.record();
  undo.undo();
  await settled();
  assert.equal(carving.carved.number, 1);
  assert.deepEqual(messages.said, []);
  carving.answers.restore = async () => false;
  undo.redo();
  await settled();
  assert.equal(messages.said.length, 1);
});

test('Combined changes are undone together', async () => {
  await undo.asOne(async () => {
    controls = { ...controls, text: 'b' };
    undo.record('text');
    controls = { ...controls, values: { preset: 'robust' } };
    undo.record('preset');
  });
  undo.undo();
  await settled();
  assert.deepEqual(controls, { text: 'a', values: { preset: 'balanced' } });
});

test('A state replaced during another change can be restored', async () => {
  const placed = new Pending();
  const loading = undo.asOne(async () => {
    controls = { ...controls, text: 'b' };
    await placed.promise;
  });
  undo.keep();
  const startingOver = undo.asOne(async () => {
    controls = { ...controls, text: 'fresh' };
    await placed.promise;
  });
  placed.resolve();
  await Promise.all([loading, startingOver]);
  undo.undo();
  await settled();
  assert.equal(controls.text, 'b');
});

test('The buttons are disabled during jobs and while a state is restored', async () => {
  controls = { ...controls, text: 'b' };
  undo.record();
  assert.equal(elements.undo.disabled, false);
  busy = true;
  undo.allow();
  assert.equal(elements.undo.disabled, true);
  busy = false;
  undo.allow();
  const placed = new Pending();
  placing.answers.place = () => placed.promise;
  elements.undo.dispatchEvent(new Event('click'));
  assert.deepEqual([elements.undo.disabled, elements.redo.disabled], [true, true]);
  placed.resolve();
  await settled();
  assert.deepEqual([elements.undo.disabled, elements.redo.disabled], [true, false]);
});
