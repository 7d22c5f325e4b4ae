// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { after, before, beforeEach, test } from 'node:test';
import { EngineClient } from '../engine/client.js';
import { message } from '../engine/message.js';
import { ResultPanel } from '../ui/result_panel.js';
import { WorkPanel } from '../ui/work_panel.js';
import { Carving } from './carving.js';
import { Jobs } from './jobs.js';
import { Placing } from './placing.js';
import { Printing } from './printing.js';
import { Signal } from './signal.js';
import { FakeMessages, Pending, crashed, fake, noRoom, replaced, settled, storeOf } from './testing.js';

const kText = 'HELLO';

/** A decoder that makes one try per picture and finds `found` in each. */
class FakeReader {
  static found = kText;
  /** @type {(event: any) => void} */ onmessage = () => {};
  /** @param {{ id: number, pictures: unknown[] }} request */
  postMessage({ id, pictures }) {
    queueMicrotask(() => this.onmessage({ data: { id, texts: pictures.map(() => FakeReader.found) } }));
  }
  terminate() {}
}

/** @type {any} */ let client;
/** @type {any} */ let placing;
/** @type {any} */ let panel;
/** @type {any} */ let pressed; // what the panel's buttons do
/** @type {(string | undefined)[]} */ let attempts; // announced next to the result
/** @type {FakeMessages} */ let messages;
/** @type {import('./work_store.js').WorkStore} */ let store;
const values = () => store.work.values;
/** @param {Record<string, string>} now */
const setValues = (now) => store.update({ values: now });
/** @type {[boolean, boolean][]} */ let shows;
/** @type {Jobs} */ let jobs;
/** @type {any} */ let printing;
/** @type {number} */ let printsSeen;
/** @type {number} */ let number; // of the module's last carving
/** @type {any[]} */ let steps; // of the module's plan; then it prints
/** @type {number} */ let explained; // times that the page said why there is no code
/** @type {Carving} */ let carving;
const latest = () => carving.carved;
const { Worker: realWorker } = globalThis;

before(() => Object.assign(globalThis, { Worker: FakeReader }));
after(() => Object.assign(globalThis, { Worker: realWorker }));
beforeEach(() => {
  FakeReader.found = kText;
  store = storeOf({ text: kText, values: { preset: 'robust' } });
  shows = [];
  number = 0;
  steps = [];
  explained = 0;
  client = fake(EngineClient, {
    engrave: async () => {
      number += 1;
      return true;
    },
    carving: async () => number,
    useCarving: async () => true,
    nextStep: async () => steps.shift() ?? { step: 'print', carving: number },
    pictures: async () => [1, 2, 3].map(() => ({ width: 8, height: 8, pixels: new Uint8Array(64) })),
    setReadings: async (/** @type {string[]} */ texts) => ({ passed: texts.every((one) => one === kText) }),
    report: async () => ({ text: kText, symbol: { modules: 21 }, verification: {} }),
  });
  placing = fake(Placing, { place: async () => {} }, { placement: { symbolMm: 20 }, moved: new Signal() });
  attempts = [];
  panel = fake(ResultPanel, {
    listen: (/** @type {any} */ listener) => void (pressed = listener),
    setAttempt: (/** @type {(() => string) | undefined} */ words) => void attempts.push(words?.()),
  });
  printing = fake(Printing);
  printsSeen = 0;
  messages = new FakeMessages();
  jobs = new Jobs({ panel: fake(WorkPanel), messages: /** @type {any} */ (messages), onBusy: () => {} });
  carving = new Carving({
    client,
    jobs,
    placing,
    panel,
    messages: /** @type {any} */ (messages),
    model: /** @type {any} */ ({ engravable: true }),
    store,
    fields: { after: (now, { setting, value }) => ({ ...now, [setting]: value }) },
    batching: {
      settings: () => /** @type {any} */ ({}),
      decided: [],
      explainMissingCode: async () => void (explained += 1),
    },
    printing,
    onRemedy: async () => {},
    onAnother: async () => {},
    guard: (action) => action(),
  });
  carving.changed.on((exists, seen) => void shows.push([exists, seen]));
  carving.printed.on(() => void (printsSeen += 1));
});

test('A carving is decoded, reported and shown', async () => {
  await carving.engrave();
  assert.equal(latest()?.report.text, kText);
  assert.equal(carving.carved?.number, 1);
  assert.ok(client.calls.some((/** @type {string} */ call) => call.startsWith('setReadings')));
  assert.deepEqual(shows.at(-1), [true, true]);
});

test('Nothing is carved if the code has no place', async () => {
  placing.placement = undefined;
  await carving.engrave();
  assert.ok(!client.calls.some((/** @type {string} */ call) => call.startsWith('engrave')));
  assert.equal(carving.carved, undefined);
  assert.equal(explained, 1);
});

test('An engraving that a lost module did not begin is made with the next one', async () => {
  const { engrave } = client.answers;
  client.answers.engrave = async () => {
    throw replaced();
  };
  await assert.rejects(carving.engrave(), { code: 'engine-replaced' });
  client.answers.engrave = engrave;
  await carving.resume();
  assert.equal(latest()?.number, 1);
  await carving.resume();
  assert.equal(number, 1, 'it is made once');
});

test('An engraving during which the module was lost is not made again', async () => {
  client.answers.engrave = async (/** @type {any} */ { onProgress }) => {
    onProgress({ stage: message('finding-depth'), fraction: 0.5 });
    throw crashed();
  };
  await assert.rejects(carving.engrave(), { code: 'engine-crashed' });
  await carving.resume();
  assert.equal(client.calls.filter((/** @type {string} */ call) => call === 'engrave').length, 1);
});

test('Cancelling restores the previous carving, which counts as the latest until then', async () => {
  await carving.engrave();
  const before = carving.carved;
  /** @type {unknown} */ let latest;
  client.answers.engrave = async () => {
    latest = carving.latest;
    return false;
  };
  await carving.engrave();
  assert.equal(latest, before);
  await settled();
  assert.equal(carving.carved, before);
  assert.equal(messages.said.at(-1), 'Cancelled. The model is unchanged.');
});

test('A second carving does not start beside the first', async () => {
  const pending = new Pending();
  client.answers.engrave = () => pending.promise;
  const first = carving.engrave();
  await settled();
  await carving.engrave();
  number += 1;
  pending.resolve(true);
  await first;
  assert.equal(client.calls.filter((/** @type {string} */ call) => call.startsWith('engrave')).length, 1);
});

test('A failed carving leaves nothing, and the next one can start', async () => {
  const { engrave } = client.answers;
  client.answers.engrave = async () => {
    throw noRoom();
  };
  await assert.rejects(carving.engrave(), { code: 'no-centre' });
  assert.equal(carving.carved, undefined);
  client.answers.engrave = engrave;
  await carving.engrave();
  assert.equal(latest()?.report.text, kText);
});

test('A code that cannot be carved as requested is carved as the plan says', async () => {
  setValues({ size: 'free' });
  const { engrave } = client.answers;
  client.answers.engrave = async (/** @type {any} */ { plan }) => {
    assert.equal(values().size, 'free', 'the controls show what was asked for until an attempt is kept');
    if (!plan.next) throw noRoom();
    return engrave();
  };
  steps = [carve('size', 'best'), print(1)];
  await carving.engrave();
  assert.equal(values().size, 'best');
  assert.equal(latest()?.work.values.size, 'best');
  assert.match(messages.said.at(-1) ?? '', /^Engraved larger/);
});

test('A text that cannot be carved as a shadow is made in a second colour', async () => {
  setValues({ content: 'text', mark: 'auto' });
  const { engrave } = client.answers;
  client.answers.engrave = async (/** @type {any} */ { plan }) => {
    if (!plan.next) throw noRoom();
    return engrave();
  };
  steps = [carve('mark', 'paint'), deliver(1)];
  await carving.engrave();
  assert.equal(values().mark, 'paint');
  assert.match(messages.said.at(-1) ?? '', /^Made in a second colour/);
});

test('If nothing that the plan tries can be carved, the first reason is shown', async () => {
  setValues({ size: 'free' });
  client.answers.engrave = async () => {
    throw noRoom();
  };
  steps = [carve('size', 'best'), deliver(0)];
  await assert.rejects(carving.engrave(), { code: 'no-centre' });
  assert.equal(values().size, 'free', 'the controls are those of the request again');
});

test('Every change marks the carving as outdated at once, and undoing it removes the mark', async () => {
  await carving.engrave();
  const before = store.work;
  /** @type {Partial<import('./work.js').Work>[]} */ const changes = [
    { text: 'HELLO!' },
    { values: { preset: 'shallow' } },
    { centreMm: [1, 2, 3] },
    { source: /** @type {any} */ ({ bytes: new Uint8Array(1), scaleToMm: 1, upAxis: 'z' }) },
    { batch: /** @type {any} */ ({ from: 'count' }) },
  ];
  for (const change of changes) {
    store.update(change);
    assert.equal(panel.calls.at(-1), 'setOutdated true', Object.keys(change)[0]);
    store.update({ batch: undefined, ...before });
    assert.equal(panel.calls.at(-1), 'setOutdated false', Object.keys(change)[0]);
  }
});

test('A carving is lost with its module', async () => {
  await carving.engrave();
  const { carved } = carving;
  await carving.dropForGood();
  assert.equal(await carving.restore(carved), false);
  assert.deepEqual(shows.at(-1), [false, false]);
});

/** @param {number} attempt  number of the carving */
const print = (attempt) => ({ step: 'print', carving: attempt });
/** @param {number} attempt  number of the carving */
const deliver = (attempt) => ({ step: 'deliver', carving: attempt });
/** @param {string} setting @param {string} value */
const carve = (setting, value) => ({ step: 'carve', carving: 1, changes: [{ setting, value }] });

/**
 * Holds back the carvings after the first; cancelling ends them.
 * @param {Pending} held
 * @returns {Promise<void>}  resolves when the second has begun
 */
function untilCancelled(held) {
  const { engrave } = client.answers;
  return new Promise((resolve) => {
    client.answers.engrave = (/** @type {any} */ { plan, signal }) => {
      if (!plan.next) return engrave();
      signal.addEventListener('abort', () => held.resolve(false));
      resolve();
      return held.promise;
    };
  });
}

test('A code that does not decode is carved with the next deeper preset', async () => {
  setValues({ preset: 'balanced' });
  steps = [carve('preset', 'robust'), print(2)];
  await carving.engrave();
  assert.equal(values().preset, 'robust');
  assert.equal(latest()?.number, 2);
});

test('A link that must be in capitals is so in the text, and the message says it', async () => {
  store.update({ text: 'https://example.org/a' });
  setValues({ preset: 'balanced' });
  steps = [carve('text', 'HTTPS://EXAMPLE.ORG/a'), print(2)];
  await carving.engrave();
  assert.equal(store.work.text, 'HTTPS://EXAMPLE.ORG/a');
  assert.deepEqual(values(), { preset: 'balanced' });
  assert.match(String(messages.said.at(-1)), /in capitals/);
});

test('A code that does not decode when carved for the print is carved for the design, with a message', async () => {
  setValues({ preset: 'balanced', carveFor: 'print' });
  steps = [carve('carveFor', 'design'), print(2)];
  await carving.engrave();
  assert.deepEqual(values(), { preset: 'balanced', carveFor: 'design' });
  assert.equal(latest()?.number, 2);
  assert.match(messages.said.at(-1) ?? '', /^Engraved for the design only/);
});

test('A code that decodes with no preset stays as requested', async () => {
  setValues({ preset: 'balanced' });
  FakeReader.found = '';
  steps = [carve('preset', 'robust'), print(1)];
  await carving.engrave();
  assert.equal(values().preset, 'balanced');
  assert.equal(client.calls.filter((/** @type {string} */ call) => call.startsWith('engrave')).length, 2);
  assert.ok(client.calls.some((/** @type {string} */ call) => call.startsWith('useCarving 1')));
});

test('Cancelling a deeper carving keeps the requested one with its readings', async () => {
  setValues({ preset: 'shallow' });
  FakeReader.found = '';
  const deeper = new Pending();
  steps = [carve('preset', 'balanced')];
  const { engrave } = client.answers;
  const begun = untilCancelled(deeper);
  const run = carving.engrave();
  await begun;
  jobs.cancel();
  await run;
  await settled();
  assert.equal(values().preset, 'shallow');
  assert.equal(messages.said.at(-1), 'Cancelled. The model is unchanged.');
  assert.equal(client.calls.filter((/** @type {string} */ call) => call === 'useCarving 1').length, 1);
  assert.equal(latest()?.work.values.preset, 'shallow');
  assert.deepEqual(shows.at(-1), [true, true]);
  client.answers.engrave = engrave;
  setValues({ preset: 'balanced' });
  await carving.engrave();
  assert.equal(latest()?.work.values.preset, 'balanced');
});

test('The print starts with the result and is added to it', async () => {
  /** @type {any} */ let tell;
  printing.answers.begin = async (/** @type {number} */ _, /** @type {any} */ listener) => void (tell = listener);
  await carving.engrave();
  assert.ok(panel.calls.includes('reveal'));
  tell({ state: 'under-way', fraction: 0.5 });
  assert.deepEqual(latest()?.printed, { state: 'under-way', fraction: 0.5 });
  assert.equal(printsSeen, 0);
  const report = /** @type {any} */ ({ text: kText, verification: {} });
  tell({ state: 'made', print: {} }, { passed: true, report });
  assert.equal(latest()?.report, report);
  assert.equal(printsSeen, 1);
});

/** Makes prints with these results, one after the other. @param {any[]} results */
const printsAre = (...results) => {
  printing.answers.begin = async (/** @type {number} */ number, /** @type {any} */ tell) => {
    const result = results.shift();
    const verification = { verdict: { prints: { level: result?.passed ? 'good' : 'barely' } } };
    tell({ state: 'made', print: {} }, { ...result, report: { text: kText, number, size: {}, verification } });
  };
};
const kDeeper = [print(1), carve('preset', 'robust')];

test('A code whose print barely decodes is carved with the next deeper preset whose print decodes', async (t) => {
  t.mock.method(performance, 'now', () => 1000 * placing.calls.length + 100 * printing.calls.length);
  setValues({ preset: 'balanced' });
  printsAre({ passed: false }, { passed: true });
  steps = [...kDeeper, print(2), deliver(2)];
  await carving.engrave();
  await settled();
  assert.equal(values().preset, 'robust');
  assert.deepEqual([latest()?.number, latest()?.work.values.preset, latest()?.printed?.state], [2, 'robust', 'made']);
  assert.equal(/** @type {any} */ (latest())?.report.number, 2);
  assert.deepEqual(shows.at(-1), [true, true]);
  assert.deepEqual(attempts, ['Engraving deeper, since the print barely reads', undefined]);
  assert.equal(latest()?.elapsedMs, 1000 + 100 * printing.calls.length, 'the time since the click');
  assert.match(messages.said.at(-1) ?? '', /the print would barely read\.$/);
});

test('A code that does not read as printed is made larger, from the settings as requested', async () => {
  setValues({ preset: 'balanced', size: 'free' });
  printsAre({ passed: false }, { passed: false }, { passed: true });
  steps = [...kDeeper, print(2), carve('size', 'best'), print(3), deliver(3)];
  await carving.engrave();
  await settled();
  assert.deepEqual(values(), { preset: 'balanced', size: 'best' });
  assert.equal(latest()?.number, 3);
  assert.match(messages.said.at(-1) ?? '', /^Engraved larger/);
});

test('If no deeper preset helps the print, the code stays as requested', async () => {
  for (const second of [{ passed: false }, undefined]) {
    setValues({ preset: 'balanced' });
    number = 0;
    printsAre({ passed: false }, second);
    steps = [...kDeeper, ...(second ? [print(2)] : []), deliver(1)];
    const { engrave } = client.answers;
    if (!second)
      client.answers.engrave = (/** @type {any} */ { plan }) => {
        if (plan.next) throw noRoom();
        return engrave();
      };
    await carving.engrave();
    await settled();
    assert.match(messages.said.at(-1) ?? '', /^Engraved\. Nothing that QRelief may change/);
    assert.equal(values().preset, 'balanced');
    assert.equal(latest()?.work.values.preset, 'balanced');
    assert.equal(latest()?.printed?.state, 'made');
    assert.deepEqual(shows.at(-1), [true, true]);
  }
});

test('Cancelling a deeper carving for the print restores the first result', async () => {
  setValues({ preset: 'balanced' });
  printsAre({ passed: false });
  steps = [...kDeeper];
  const begun = untilCancelled(new Pending());
  await carving.engrave();
  await begun;
  jobs.cancel();
  await jobs.untilIdle();
  await settled();
  assert.deepEqual([values().preset, latest()?.work.values.preset, latest()?.number], ['balanced', 'balanced', 1]);
  assert.equal(messages.said.at(-1), 'Cancelled. The code keeps the depth you chose.');
  assert.deepEqual(shows.at(-1), [true, true]);
});

test('While a deeper carving is made, the first result and its settings stay, and its file can be saved', async (t) => {
  setValues({ preset: 'balanced' });
  store.update({ source: /** @type {any} */ ({ fileName: 'cup.stl' }) });
  printsAre({ passed: false }, { passed: true });
  steps = [...kDeeper, print(2), deliver(2)];
  const deeper = new Pending();
  const begun = untilCancelled(deeper);
  await carving.engrave();
  const hidden = panel.calls.filter((/** @type {string} */ call) => call === 'hide').length;
  await begun;
  assert.deepEqual([values().preset, latest()?.number], ['balanced', 1]);
  assert.deepEqual(attempts, ['Engraving deeper, since the print barely reads']);
  assert.equal(panel.calls.filter((/** @type {string} */ call) => call === 'hide').length, hidden);
  const link = { download: '', click: () => {} };
  Object.assign(globalThis, { document: { createElement: () => link } });
  t.mock.timers.enable({ apis: ['setTimeout'] }); // otherwise the saved file would be kept for a minute
  await pressed.onDownload({ format: 'stl', slicer: 'any' });
  Reflect.deleteProperty(globalThis, 'document');
  assert.ok(client.calls.includes('exportModel stl any 1'));
  assert.match(link.download, /^cup-/);
  number += 1;
  deeper.resolve(true);
  await jobs.untilIdle();
  assert.deepEqual([values().preset, latest()?.number], ['robust', 2]);
});

test('A change by the user ends the attempts for the print, and stays', async () => {
  setValues({ preset: 'balanced' });
  printsAre({ passed: false });
  steps = [...kDeeper, print(2), deliver(2)];
  const deeper = new Pending();
  const begun = untilCancelled(deeper);
  await carving.engrave();
  await begun;
  setValues({ preset: 'shallow' });
  number += 1;
  deeper.resolve(true);
  await jobs.untilIdle();
  await settled();
  assert.deepEqual([values().preset, latest()?.number], ['shallow', 1]);
  assert.match(messages.said.at(-1) ?? '', /^Made before your last change/);
});

test('A code is not carved again for its print after a change by the user', async () => {
  setValues({ preset: 'balanced' });
  /** @type {any} */ let tell;
  printing.answers.begin = async (/** @type {number} */ _, /** @type {any} */ listener) => void (tell = listener);
  await carving.engrave();
  setValues({ preset: 'shallow' });
  tell({ state: 'made', print: {} }, { passed: false, report: { text: kText } });
  await settled();
  assert.equal(client.calls.filter((/** @type {string} */ call) => call.startsWith('engrave')).length, 1);
});

test('Dropping a carving stops its print', async () => {
  client.answers.engrave = async (/** @type {any} */ { onPrintable }) => {
    onPrintable({});
    return client.calls.filter((/** @type {string} */ call) => call === 'engrave').length === 1;
  };
  FakeReader.found = 'something else';
  setValues({ preset: 'balanced' });
  steps = [carve('preset', 'robust')];
  await carving.engrave();
  const calls = printing.calls.filter((/** @type {string} */ call) => ['beginEarly', 'stop'].includes(call));
  assert.deepEqual(
    calls.slice(calls.indexOf('beginEarly')).slice(0, 3),
    ['beginEarly', 'beginEarly', 'stop'],
    'the deeper one was cancelled',
  );
});

test('The print of a replaced carving is reported to that carving', async () => {
  /** @type {any[]} */ const tells = [];
  printing.answers.begin = async (/** @type {number} */ _, /** @type {any} */ listener) => void tells.push(listener);
  await carving.engrave();
  const first = carving.carved;
  await carving.engrave();
  const second = carving.carved;
  const updates = panel.calls.filter((/** @type {string} */ call) => call === 'update').length;
  tells[0]({ state: 'stopped' });
  assert.deepEqual(first?.printed, { state: 'stopped' });
  assert.equal(second?.printed, undefined);
  assert.equal(panel.calls.filter((/** @type {string} */ call) => call === 'update').length, updates);
});

test('A restored carving is printed only if it has no print', async () => {
  await carving.engrave();
  const { carved } = carving;
  const begun = () => printing.calls.filter((/** @type {string} */ call) => call.startsWith('begin')).length;
  assert.equal(begun(), 1);
  await carving.restore(carved);
  assert.equal(begun(), 2);
  if (carved) carved.printed = /** @type {any} */ ({ state: 'made', print: {} });
  await carving.restore(carved);
  assert.equal(begun(), 2);
});
