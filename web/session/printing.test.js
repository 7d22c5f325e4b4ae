// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { EngineClient } from '../engine/client.js';
import { Printing } from './printing.js';
import { Pending, crashed, fake, settled } from './testing.js';

/** @typedef {import('../engine/types.js').Printed} Printed */

/** @type {any} */ let client;
/** @type {Pending} */ let pending;
/** @type {any[]} */ let jobs;
/** @type {[Printed, unknown][]} */ let reports;
/** @type {Printing} */ let printing;
const tell = (/** @type {Printed} */ printed, /** @type {unknown} */ report) => void reports.push([printed, report]);
const states = () => reports.map(([{ state }]) => state);

beforeEach(() => {
  client = fake(EngineClient, {
    printJob: async () => ({ order: {}, stl: new Uint8Array(3) }),
    setPrintedReadings: async () => ({ passed: true, next: null, report: { text: 'with the print' } }),
  });
  pending = new Pending();
  jobs = [];
  reports = [];
  printing = new Printing({
    client,
    make: async (job, { signal, onProgress }) => {
      jobs.push({ job, signal });
      onProgress(0.5);
      return /** @type {any} */ (pending.promise);
    },
    read: async (pictures) => pictures.map(() => 'HELLO'),
  });
});

const print = () => ({ facingDeg: 30, misread: [[1, 2]], pictures: [1, 2], picture: {} });

test('A print is simulated, decoded and reported', async () => {
  const run = printing.begin(7, tell);
  await settled();
  assert.deepEqual(
    reports.map(([printed]) => printed),
    [{ state: 'under-way', fraction: 0.5 }],
  );
  pending.resolve(print());
  await run;
  assert.deepEqual(reports.at(-1), [
    { state: 'made', print: { ...print(), pictures: [] } },
    { passed: true, next: null, report: { text: 'with the print' } },
  ]);
  assert.ok(client.calls.includes('setPrintedReadings 7 30'));
});

test('A print started before the carving is done is made once and reports progress', async () => {
  printing.beginEarly(/** @type {any} */ ({ order: {}, stl: new Uint8Array(5) }));
  await settled();
  const run = printing.begin(7, tell);
  pending.resolve(print());
  await run;
  assert.equal(jobs.length, 1);
  assert.equal(jobs[0].job.stl.length, 5);
  assert.ok(!client.calls.includes('printJob'));
  assert.deepEqual(
    reports.map(([printed]) => [printed.state, /** @type {any} */ (printed).fraction]),
    [
      ['under-way', 0.5],
      ['made', undefined],
    ],
  );
});

test('A print started for a dropped carving is not used for another', async () => {
  printing.beginEarly(/** @type {any} */ ({ order: {}, stl: new Uint8Array(5) }));
  printing.stop();
  assert.ok(jobs[0].signal.aborted);
  const run = printing.begin(8, tell);
  await settled();
  pending.resolve(print());
  await run;
  assert.equal(jobs.length, 2);
  assert.equal(jobs[1].job.stl.length, 3);
});

test('A carving without a print is told so, early or late', async () => {
  printing.beginEarly(null);
  await printing.begin(1, tell);
  assert.deepEqual(states(), ['none']);
});

test('Without a process nothing is made', async () => {
  client.answers.printJob = async () => null;
  await printing.begin(1, tell);
  assert.deepEqual(states(), ['none']);
  assert.equal(jobs.length, 0);
});

test('Stopping ends it at once with a message, and later results are ignored', async () => {
  const run = printing.begin(1, tell);
  await settled();
  printing.stop();
  assert.ok(jobs[0].signal.aborted);
  pending.resolve(print());
  await run;
  assert.equal(states().at(-1), 'stopped');
  assert.ok(!client.calls.some((/** @type {string} */ call) => call.startsWith('setPrintedReadings')));
});

test('The next print replaces the running one', async () => {
  const first = printing.begin(1, tell);
  await settled();
  /** @type {any[]} */ const others = [];
  const second = printing.begin(2, (printed) => void others.push(printed.state));
  await settled();
  pending.resolve(print());
  await Promise.all([first, second]);
  assert.equal(states().at(-1), 'stopped');
  assert.equal(others.at(-1), 'made');
});

test('An error is reported as it is, not as an engine failure', async () => {
  const run = printing.begin(1, tell);
  await settled();
  pending.reject(crashed());
  await run;
  const [last] = /** @type {any} */ (reports.at(-1));
  assert.equal(last.state, 'failed');
  assert.equal(last.error.code, 'engine-crashed');
});

test('The print of a lost carving is dropped', async () => {
  client.answers.setPrintedReadings = async () => null;
  const run = printing.begin(1, tell);
  pending.resolve(print());
  await run;
  assert.deepEqual(states(), ['under-way']);
});

test('Other processes are tried one after the other, and each result is reported', async () => {
  client.answers.judgePrint = async (/** @type {number} */ _, /** @type {any} */ change) => ({
    level: change.buildUp ? 'good' : 'bad',
  });
  pending.resolve(print());
  /** @type {any[]} */ const trials = [];
  client.answers.otherPrints = async () => [{ buildUp: 'code-up' }, { process: 'resin-0.05' }];
  await printing.tryOthers(7, (one) => void trials.push(one));
  assert.deepEqual(trials[0], { tried: [], all: 2, fraction: 0 });
  assert.deepEqual(trials.at(-1), {
    tried: [
      { change: { buildUp: 'code-up' }, prints: { level: 'good' } },
      { change: { process: 'resin-0.05' }, prints: { level: 'bad' } },
    ],
    all: 2,
  });
});

test('Stopping keeps the trials so far', async () => {
  client.answers.judgePrint = async () => ({ level: 'good' });
  /** @type {any[]} */ const trials = [];
  client.answers.otherPrints = async () => [{ buildUp: 'code-up' }, { buildUp: 'code-upright' }];
  const run = printing.tryOthers(7, (one) => {
    trials.push(one);
    if (one.tried.length === 1) printing.stop();
  });
  pending.resolve(print());
  await run;
  assert.deepEqual(trials.at(-1), { tried: [{ change: { buildUp: 'code-up' }, prints: { level: 'good' } }], all: 2 });
});

test('A failed trial is reported with the trials so far, not as an engine failure', async () => {
  pending.promise.catch(() => {});
  pending.reject(crashed());
  /** @type {any[]} */ const trials = [];
  client.answers.otherPrints = async () => [{ buildUp: 'code-up' }];
  await printing.tryOthers(7, (one) => void trials.push(one));
  const { tried, error } = trials.at(-1);
  assert.deepEqual(tried, []);
  assert.equal(error.code, 'engine-crashed');
});
