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

/** A decoder that makes one try per picture. */
class FakeReader {
  /** @type {(event: any) => void} */ onmessage = () => {};
  /** @param {{ id: number, pictures: unknown[] }} request */
  postMessage({ id, pictures }) {
    queueMicrotask(() => this.onmessage({ data: { id, texts: pictures.map(() => kText) } }));
  }
  terminate() {}
}

/** @type {any} */ let client;
/** @type {any} */ let placing;
/** @type {any} */ let panel;
/** @type {any} */ let work; // the panel with the progress
/** @type {any} */ let pressed; // what the panel's buttons do
/** @type {(string | undefined)[]} */ let attempts; // announced next to the result
/** @type {FakeMessages} */ let messages;
/** @type {import('./work_store.js').WorkStore} */ let store;
const settings = () => store.work.settings;
/** @param {Record<string, string>} now */
const setSettings = (now) => store.update({ settings: now });
/** @type {[boolean, boolean][]} */ let shows;
/** @type {Jobs} */ let jobs;
/** @type {any} */ let printing;
/** @type {number} */ let printsSeen;
/** @type {any[]} */ let steps; // what the module's engraving needs, one after the other, or how it goes on
/** @type {any} */ let best; // delivery of an engraving that ends early
/** @type {number} */ let explained; // times that the page said why there is no code
/** @type {Carving} */ let carving;
const latest = () => carving.carved;
const { Worker: realWorker } = globalThis;

/** @param {string} [prints] @param {string} [reads]  levels of these questions */
const verificationOf = (prints = 'good', reads = 'good') => ({
  verdict: { reads: { level: reads }, prints: { level: prints } },
});
/** @param {number} number */
const reportOf = (number) => /** @type {any} */ ({ text: kText, number, size: {}, verification: verificationOf() });
/** @param {number} number  of the carving */
const delivery = (number) => ({ number, report: reportOf(number), seen: undefined });
/** @param {number} carving @param {string[]} change  its setting and value */
const texts = (carving, ...[setting, value]) => ({
  needs: 'texts',
  carving,
  pictures: [1, 2, 3].map(() => ({ width: 8, height: 8, pixels: new Uint8Array(64) })),
  changes: setting ? [{ setting, value }] : [],
});
/** @param {any} read  what was decoded @param {'print' | null} needs @param {number} [number]  of the best */
const read = ({ carving, changes }, needs = /** @type {any} */ ('print'), number = carving) => ({
  needs,
  carving,
  best: number,
  changes,
  pictures: [],
  delivery: delivery(carving),
});
const kFirst = texts(1);
const engravings = () => client.calls.filter((/** @type {string} */ call) => call === 'engrave').length;

before(() => Object.assign(globalThis, { Worker: FakeReader }));
after(() => Object.assign(globalThis, { Worker: realWorker }));
beforeEach(() => {
  store = storeOf({ text: kText, settings: { preset: 'robust' } });
  shows = [];
  steps = [kFirst, read(kFirst)];
  best = null;
  explained = 0;
  const goOn = async (/** @type {any} */ job) => {
    const step = steps.shift();
    if (step instanceof Error) throw step;
    if (typeof step === 'function') return step(job);
    job.onProgress({ stage: message('finding-depth'), fraction: 0.5, changes: step.changes });
    return step;
  };
  client = fake(EngineClient, {
    engrave: goOn,
    continueEngrave: goOn,
    endEngrave: async () => best,
    useCarving: async () => true,
    report: async () => reportOf(1),
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
  work = fake(WorkPanel);
  jobs = new Jobs({ panel: work, messages: /** @type {any} */ (messages), onBusy: () => {} });
  carving = new Carving({
    client,
    jobs,
    placing,
    panel,
    messages: /** @type {any} */ (messages),
    model: /** @type {any} */ ({ engravable: true }),
    store,
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
  assert.equal(client.calls.filter((/** @type {string} */ call) => call.startsWith('continueEngrave')).length, 1);
  assert.deepEqual(shows.at(-1), [true, true]);
});

test('A code that does not read is not said to be ready', async () => {
  const unread = delivery(1);
  unread.report.verification = verificationOf('good', 'bad');
  steps = [kFirst, { ...read(kFirst), delivery: unread }];
  await carving.engrave();
  assert.match(messages.said.at(-1) ?? '', /does not read reliably/);
});

test('Nothing is carved if the code has no place', async () => {
  placing.placement = undefined;
  await carving.engrave();
  assert.ok(!client.calls.some((/** @type {string} */ call) => call.startsWith('engrave')));
  assert.equal(carving.carved, undefined);
  assert.equal(explained, 1);
});

test('An engraving that a lost module did not begin is made with the next one', async () => {
  steps.unshift(replaced());
  await assert.rejects(carving.engrave(), { code: 'engine-replaced' });
  await carving.resume();
  assert.equal(latest()?.number, 1);
  await carving.resume();
  assert.equal(engravings(), 2, 'it is made once');
});

test('An engraving during which the module was lost is not made again', async () => {
  steps = [
    (/** @type {any} */ { onProgress }) => {
      onProgress({ stage: message('finding-depth'), fraction: 0.5 });
      throw crashed();
    },
  ];
  await assert.rejects(carving.engrave(), { code: 'engine-crashed' });
  await carving.resume();
  assert.equal(engravings(), 1);
});

/** A step that lasts until the user cancels. @param {() => void} [begun] */
const untilCancelled =
  (begun) =>
  (/** @type {any} */ { signal }) => {
    const held = new Pending();
    signal.addEventListener('abort', () => held.resolve(undefined));
    begun?.();
    return held.promise;
  };

test('Cancelling restores the previous carving, which counts as the latest until then', async () => {
  await carving.engrave();
  const before = carving.carved;
  /** @type {unknown} */ let latest;
  steps = [
    untilCancelled(() => {
      ({ latest } = carving);
      queueMicrotask(() => jobs.cancel());
    }),
  ];
  await carving.engrave();
  assert.equal(latest, before);
  await settled();
  assert.equal(carving.carved, before);
  assert.equal(messages.said.at(-1), 'Cancelled. The model is unchanged.');
});

test('A second carving does not start beside the first', async () => {
  const pending = new Pending();
  steps.unshift(() => pending.promise);
  const first = carving.engrave();
  await settled();
  await carving.engrave();
  pending.resolve(kFirst);
  steps = [read(kFirst)];
  await first;
  assert.equal(engravings(), 1);
});

test('A failed carving leaves nothing, and the next one can start', async () => {
  steps.unshift(noRoom());
  await assert.rejects(carving.engrave(), { code: 'no-centre' });
  assert.equal(carving.carved, undefined);
  await carving.engrave();
  assert.equal(latest()?.report.text, kText);
});

test('A code that cannot be carved as requested is carved with changes', async () => {
  setSettings({ size: 'free' });
  const second = texts(1, 'size', 'best');
  steps = [
    (/** @type {any} */ { onProgress }) => {
      onProgress({ stage: message('finding-depth'), fraction: 0, changes: second.changes });
      assert.equal(settings().size, 'free', 'the controls show what was asked for until an attempt is kept');
      return second;
    },
    read(second),
  ];
  await carving.engrave();
  assert.equal(settings().size, 'best');
  assert.equal(latest()?.work.settings.size, 'best');
  assert.match(messages.said.join(), /since it cannot be engraved as chosen/);
  assert.match(messages.said.at(-1) ?? '', /^Engraved larger/);
});

test('A text that cannot be carved as a shadow is made in a second colour', async () => {
  setSettings({ content: 'text', mark: 'auto' });
  steps = [read(texts(1, 'mark', 'paint'), null)];
  await carving.engrave();
  assert.equal(settings().mark, 'paint');
  assert.match(messages.said.at(-1) ?? '', /^Made in a second colour/);
});

test('Every change marks the carving as outdated at once, and undoing it removes the mark', async () => {
  await carving.engrave();
  const before = store.work;
  /** @type {Partial<import('./work.js').Work>[]} */ const changes = [
    { text: 'HELLO!' },
    { settings: { preset: 'shallow' } },
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

test('A code that does not decode is carved with the next deeper preset', async () => {
  setSettings({ preset: 'balanced' });
  const second = texts(2, 'preset', 'robust');
  steps = [kFirst, second, read(second)];
  await carving.engrave();
  assert.equal(settings().preset, 'robust');
  assert.equal(latest()?.number, 2);
});

test('A link that must be in capitals is so in the text, and the message says it', async () => {
  store.update({ text: 'https://example.org/a' });
  setSettings({ preset: 'balanced' });
  const second = texts(2, 'text', 'HTTPS://EXAMPLE.ORG/a');
  steps = [kFirst, second, read(second)];
  await carving.engrave();
  assert.equal(store.work.text, 'HTTPS://EXAMPLE.ORG/a');
  assert.deepEqual(settings(), { preset: 'balanced' });
  assert.match(String(messages.said.at(-1)), /in capitals/);
});

test('A code that does not decode when carved for the print is carved for the design, with a message', async () => {
  setSettings({ preset: 'balanced', carveFor: 'print' });
  const second = texts(2, 'carveFor', 'design');
  steps = [kFirst, second, read(second)];
  await carving.engrave();
  assert.deepEqual(settings(), { preset: 'balanced', carveFor: 'design' });
  assert.equal(latest()?.number, 2);
  assert.match(messages.said.at(-1) ?? '', /^Engraved for the design only/);
});

test('A code that decodes with no preset stays as requested, and is printed instead of the last attempt', async () => {
  setSettings({ preset: 'balanced' });
  steps = [kFirst, texts(2, 'preset', 'robust'), read(kFirst)];
  await carving.engrave();
  assert.equal(settings().preset, 'balanced');
  assert.equal(latest()?.number, 1);
  const calls = printing.calls.filter((/** @type {string} */ call) => /^(stop|begin)/.test(call));
  assert.deepEqual(calls.slice(-2), ['stop', 'begin 1']);
});

test('Cancelling a deeper carving keeps the requested one with its readings', async () => {
  setSettings({ preset: 'shallow' });
  const begun = new Pending();
  steps = [kFirst, untilCancelled(() => begun.resolve())];
  best = delivery(1);
  const run = carving.engrave();
  await begun.promise;
  jobs.cancel();
  await run;
  await settled();
  assert.equal(settings().preset, 'shallow');
  assert.equal(messages.said.at(-1), 'Cancelled. The model is unchanged.');
  assert.equal(latest()?.number, 1);
  assert.equal(latest()?.work.settings.preset, 'shallow');
  assert.deepEqual(shows.at(-1), [true, true]);
  setSettings({ preset: 'balanced' });
  steps = [kFirst, read(kFirst)];
  await carving.engrave();
  assert.equal(latest()?.work.settings.preset, 'balanced');
});

test('A change by the user ends the attempts, and what is there is kept as outdated', async () => {
  setSettings({ preset: 'balanced' });
  client.answers.show = async (/** @type {any} */ { carved }) => carved && setSettings({ preset: 'shallow' }); // while it is decoded
  steps = [kFirst];
  best = delivery(1);
  await carving.engrave();
  assert.deepEqual([settings().preset, latest()?.number], ['shallow', 1]);
  assert.ok(client.calls.includes('endEngrave'));
  assert.equal(
    panel.calls.filter((/** @type {string} */ call) => /^setOutdated/.test(call)).at(-1),
    'setOutdated true',
  );
});

test('The print starts with the result and is added to it', async () => {
  /** @type {any} */ let tell;
  printing.answers.begin = async (/** @type {number} */ _, /** @type {any} */ listener) => void (tell = listener);
  await carving.engrave();
  assert.ok(panel.calls.includes('reveal'));
  tell({ state: 'under-way', fraction: 0.5 });
  assert.deepEqual(latest()?.printed, { state: 'under-way', fraction: 0.5 });
  assert.equal(printsSeen, 0);
  const report = /** @type {any} */ ({ text: kText, verification: verificationOf() });
  tell({ state: 'made', print: {} }, { passed: true, report });
  assert.equal(latest()?.report, report);
  assert.equal(printsSeen, 1);
});

/** Makes prints with these results, one after the other. After the last one nothing is left to try. @param {any[]} results */
const printsAre = (...results) => {
  printing.answers.begin = async (/** @type {number} */ number, /** @type {any} */ tell) => {
    const result = { ...results.shift(), more: results.length > 0 };
    const verification = verificationOf(result?.passed ? 'good' : 'barely');
    tell({ state: 'made', print: {} }, { ...result, report: { text: kText, number, size: {}, verification } });
  };
};
const kDeeper = texts(2, 'preset', 'robust');
/** The engraving until the print of the first attempt. */
const kOnce = [kFirst, read(kFirst)];

test('A code whose print barely decodes is carved with the next deeper preset whose print decodes', async (t) => {
  t.mock.method(performance, 'now', () => 1000 * placing.calls.length + 100 * printing.calls.length);
  setSettings({ preset: 'balanced' });
  printsAre({ passed: false }, { passed: true });
  steps = [...kOnce, kDeeper, read(kDeeper), read(kDeeper, null)];
  await carving.engrave();
  await settled();
  assert.equal(settings().preset, 'robust');
  assert.deepEqual([latest()?.number, latest()?.work.settings.preset, latest()?.printed?.state], [2, 'robust', 'made']);
  assert.equal(/** @type {any} */ (latest())?.report.number, 2);
  assert.deepEqual(shows.at(-1), [true, true]);
  assert.deepEqual(attempts, ['Engraving deeper, since the print barely reads', undefined]);
  assert.equal(latest()?.elapsedMs, 1000 + 100 * printing.calls.length, 'the time since the click');
  assert.match(messages.said.at(-1) ?? '', /the print would barely read\.$/);
});

test('The progress of one click on Engrave never goes back, not even for attempts after the print', async () => {
  setSettings({ preset: 'balanced' });
  printsAre({ passed: false }, { passed: true });
  const at =
    (/** @type {number} */ fraction, /** @type {any} */ step) =>
    (/** @type {any} */ { onProgress }) => {
      onProgress({ stage: message('finding-depth'), fraction, changes: step.changes });
      return step;
    };
  steps = [at(0.5, kFirst), at(0.6, read(kFirst)), at(0.2, kDeeper), at(0.9, read(kDeeper)), read(kDeeper, null)];
  await carving.engrave();
  await settled();
  const shown = work.calls.flatMap(
    (/** @type {string} */ call) => /^(?:begin|update) .*?([\d.]+)/.exec(call)?.[1] ?? [],
  );
  assert.deepEqual(shown.map(Number), [0.5, 0.6, 0.6, 0.6, 0.9, 0.9]);
});

test('A code that does not read as printed is made larger, from the settings as requested', async () => {
  setSettings({ preset: 'balanced', size: 'free' });
  printsAre({ passed: false }, { passed: false }, { passed: true });
  const larger = texts(3, 'size', 'best');
  steps = [...kOnce, kDeeper, read(kDeeper, 'print', 1), larger, read(larger, 'print', 1), read(larger, null)];
  await carving.engrave();
  await settled();
  assert.deepEqual(settings(), { preset: 'balanced', size: 'best' });
  assert.equal(latest()?.number, 3);
  assert.match(messages.said.at(-1) ?? '', /^Engraved larger/);
});

test('If no deeper preset helps the print, the code stays as requested', async () => {
  for (const isRead of [true, false]) {
    setSettings({ preset: 'balanced' });
    printsAre({ passed: false }, { passed: false });
    steps = [...kOnce, kDeeper, ...(isRead ? [read(kDeeper, 'print', 1)] : []), read(kFirst, null)];
    await carving.engrave();
    await settled();
    assert.match(messages.said.at(-1) ?? '', /^Engraved\. Nothing that QRelief may change/);
    assert.equal(settings().preset, 'balanced');
    assert.equal(latest()?.work.settings.preset, 'balanced');
    assert.equal(latest()?.printed?.state, 'made');
    assert.deepEqual(shows.at(-1), [true, true]);
  }
});

test('Cancelling a deeper carving for the print restores the first result', async () => {
  setSettings({ preset: 'balanced' });
  printsAre({ passed: false }, {});
  const begun = new Pending();
  steps = [...kOnce, untilCancelled(() => begun.resolve())];
  await carving.engrave();
  await begun.promise;
  jobs.cancel();
  await jobs.untilIdle();
  await settled();
  assert.deepEqual([settings().preset, latest()?.work.settings.preset, latest()?.number], ['balanced', 'balanced', 1]);
  assert.equal(messages.said.at(-1), 'Cancelled. The code keeps the depth you chose.');
  assert.deepEqual(shows.at(-1), [true, true]);
});

/** Holds back the deeper carving, which has begun when `begun` resolves. */
function heldBack() {
  const deeper = new Pending();
  const started = new Pending();
  const hold = (/** @type {any} */ { onProgress }) => {
    onProgress({ stage: message('finding-depth'), fraction: 0, changes: kDeeper.changes });
    started.resolve();
    return deeper.promise;
  };
  steps = [...kOnce, hold, read(kDeeper), read(kDeeper, null)];
  return { deeper, begun: started.promise };
}

test('While a deeper carving is made, the first result and its settings stay, and its file can be saved', async (t) => {
  setSettings({ preset: 'balanced' });
  store.update({ source: /** @type {any} */ ({ fileName: 'cup.stl' }) });
  printsAre({ passed: false }, { passed: true });
  const { deeper, begun } = heldBack();
  await carving.engrave();
  const hidden = panel.calls.filter((/** @type {string} */ call) => call === 'hide').length;
  await begun;
  assert.deepEqual([settings().preset, latest()?.number], ['balanced', 1]);
  assert.deepEqual(attempts, ['Engraving deeper, since the print barely reads']);
  assert.equal(panel.calls.filter((/** @type {string} */ call) => call === 'hide').length, hidden);
  const link = { download: '', click: () => {} };
  Object.assign(globalThis, { document: { createElement: () => link } });
  t.mock.timers.enable({ apis: ['setTimeout'] }); // otherwise the saved file would be kept for a minute
  await pressed.onDownload({ format: 'stl', slicer: 'any' });
  Reflect.deleteProperty(globalThis, 'document');
  assert.ok(client.calls.includes('exportModel stl any 1'));
  assert.match(link.download, /^cup-/);
  deeper.resolve(kDeeper);
  await jobs.untilIdle();
  assert.deepEqual([settings().preset, latest()?.number], ['robust', 2]);
});

test('A change by the user ends the attempts for the print, and stays', async () => {
  setSettings({ preset: 'balanced' });
  printsAre({ passed: false }, {});
  const { deeper, begun } = heldBack();
  await carving.engrave();
  await begun;
  setSettings({ preset: 'shallow' });
  deeper.resolve(kDeeper);
  await jobs.untilIdle();
  await settled();
  assert.deepEqual([settings().preset, latest()?.number], ['shallow', 1]);
  assert.match(messages.said.at(-1) ?? '', /^Made before your last change/);
});

test('A code is not carved again for its print after a change by the user', async () => {
  setSettings({ preset: 'balanced' });
  /** @type {any} */ let tell;
  printing.answers.begin = async (/** @type {number} */ _, /** @type {any} */ listener) => void (tell = listener);
  await carving.engrave();
  setSettings({ preset: 'shallow' });
  tell({ state: 'made', print: {} }, { passed: false, more: true, report: reportOf(1) });
  await settled();
  assert.equal(client.calls.filter((/** @type {string} */ call) => /^continueEngrave/.test(call)).length, 1);
});

test('Cancelling stops the print that has begun', async () => {
  steps = [
    (/** @type {any} */ job) => {
      job.onPrintable({});
      queueMicrotask(() => jobs.cancel());
      return untilCancelled()(job);
    },
  ];
  await carving.engrave();
  await settled();
  const calls = printing.calls.filter((/** @type {string} */ call) => ['beginEarly', 'stop'].includes(call));
  assert.deepEqual(calls.slice(calls.indexOf('beginEarly')).slice(0, 2), ['beginEarly', 'stop']);
});

test('The print of a replaced carving is reported to that carving', async () => {
  /** @type {any[]} */ const tells = [];
  printing.answers.begin = async (/** @type {number} */ _, /** @type {any} */ listener) => void tells.push(listener);
  await carving.engrave();
  const first = carving.carved;
  steps = [kFirst, read(kFirst)];
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
