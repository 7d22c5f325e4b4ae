// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { EngineFailure, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { sha256 } from './hashes.js';
import { RowEngine } from './row_engine.js';

const kJob = /** @type {any} */ ({
  model: { bytes: new Uint8Array(3), fileName: 'cube.stl', scaleToMm: 25.4, upAxis: 'y' },
  input: 'aa',
  centreMm: [1, 2, 3],
  list: new Uint8Array(),
  wanted: { settings: { text: '', preset: 'balanced' }, text: '', name: '', count: 2, perPlate: 0 },
});

/** @type {string[]} */ let calls;
/** @type {any[]} */ let configured;
/** @type {any[]} */ let nexts;
/** @type {any} */ let answers;
/** @type {RowEngine} */ let engine;
/** Carves the second row. @param {boolean} looks */
const carveSecond = async (looks = false) => {
  const {
    rows: [row],
    bytes,
    file,
  } = await engine.carve([1], () => looks);
  return { ...row, bytes, file };
};

beforeEach(() => {
  calls = [];
  configured = [];
  nexts = [null];
  answers = {
    start: { problems: [] },
    batchRow: { number: 2, line: 3, id: 'b', text: 'two', file: 'b.3mf', settings: { text: 'two', version: 1 } },
    batchRowToHash: 'hash me',
    setReadings: () => ({ passed: true, next: nexts.shift() }),
    configure: (/** @type {any} */ settings) => void configured.push(settings),
    describeRow: { passed: true, failed: [], details: { grades: 'A' } },
    exportModel: new Uint8Array([1, 2]),
    printJob: { order: {}, stl: new Uint8Array() },
    carving: 7,
    setPrintedReadings: () => ({ passed: true, next: null }),
  };
  const client = new Proxy(
    {},
    {
      get:
        (_, name) =>
        async (/** @type {any[]} */ ...args) => {
          calls.push([name, ...args.filter((arg) => typeof arg !== 'object')].join(' '));
          const answer = answers[name];
          if (answer instanceof Error) throw answer;
          return typeof answer === 'function' ? answer(...args) : answer;
        },
    },
  );
  engine = new RowEngine(kJob, {
    client: /** @type {any} */ (client),
    read: async () => ['two'],
    print: async () => /** @type {any} */ ({ pictures: [], facingDeg: 12 }),
  });
});

test('An engine gets the common settings once', async () => {
  await engine.start();
  assert.deepEqual(calls, ['start', 'setUpAxis y', 'loadModel cube.stl 25.4', 'planBatch', 'setCentre']);
});

test('A row is carved with common and own settings, and its line has the hashes of its inputs', async () => {
  const carved = await carveSecond();
  assert.deepEqual(configured, [{ text: 'two', preset: 'balanced', version: 1 }]);
  assert.deepEqual(carved.entry, {
    number: 2,
    id: 'b',
    text: 'two',
    file: 'b.3mf',
    status: 'done',
    grades: 'A',
    sha256: { input: 'aa', settings: await sha256('hash me'), output: await sha256(new Uint8Array([1, 2])) },
  });
  assert.deepEqual([...(carved.bytes ?? [])], [1, 2]);
  assert.ok(calls.includes('exportModel 3mf'));
  assert.ok(!calls.includes('printJob'));
});

test('The print is simulated on request', async () => {
  await carveSecond(true);
  assert.ok(calls.includes('setPrintedReadings 7 12'));
});

test('A row that does not decode is carved as the module proposes', async () => {
  nexts = [{ setting: 'preset', value: 'robust' }, null];
  assert.equal((await carveSecond()).entry.status, 'done');
  assert.deepEqual(
    configured.map(({ preset }) => preset),
    ['balanced', 'robust'],
  );
});

test('A row whose print barely decodes is carved deeper, and keeps that only if the print then decodes', async () => {
  const robust = { setting: 'preset', value: 'robust' };
  for (const isMended of [true, false]) {
    calls = [];
    configured = [];
    nexts = [null, null];
    const prints = [
      { passed: false, next: robust },
      { passed: isMended, next: null },
    ];
    answers.setPrintedReadings = () => prints.shift();
    assert.equal((await carveSecond(true)).entry.status, 'done');
    assert.deepEqual(
      configured.map(({ preset }) => preset),
      ['balanced', 'robust'],
    );
    assert.equal(calls.includes('useCarving 7'), !isMended);
  }
});

test('A row that cannot be carved deeper for its print stays as requested', async () => {
  answers.setPrintedReadings = () => ({ passed: false, next: { setting: 'preset', value: 'robust' } });
  let carvings = 0;
  answers.engrave = () => {
    carvings += 1;
    if (carvings === 2) throw new EngineFailure({ kind: 'NoSolution', ...message('no-centre') });
  };
  assert.equal((await carveSecond(true)).entry.status, 'done');
  assert.ok(calls.includes('useCarving 7'));
});

test('A row with failed checks has no file and names the checks', async () => {
  answers.describeRow = { passed: false, failed: [message('row-without-text')], details: { grades: 'F' } };
  const carved = await carveSecond();
  assert.deepEqual(
    [carved.entry.status, /** @type {any} */ (carved.entry).grades, carved.why?.code, carved.bytes],
    ['failed', 'F', 'row-without-text', undefined],
  );
});

test('A row that cannot be carved fails; a broken engine is reported', async () => {
  answers.engrave = new EngineFailure({ kind: 'NoSolution', ...message('no-centre') });
  const carved = await carveSecond();
  assert.deepEqual([carved.entry.status, carved.why?.code], ['failed', 'no-centre']);
  answers.engrave = new EngineFailure(internal(message('engine-crashed', { detail: { term: 'unreachable' } })));
  await assert.rejects(carveSecond(), { code: 'engine-crashed' });
});

test('An inlay is written for a row that requests it', async () => {
  answers.batchRow.settings.inlay = true;
  await carveSecond();
  assert.ok(calls.includes('exportModel 3mf-inlay'));
});

test('A row whose file cannot be written fails', async () => {
  answers.exportModel = new EngineFailure(internal(message('model-not-written', { format: { term: 'STL' } })));
  const carved = await carveSecond();
  assert.deepEqual([carved.entry.status, carved.why?.code, carved.bytes], ['failed', 'model-not-written', undefined]);
});

test('Rows of a plate share its file, without those that failed', async () => {
  const job = { ...kJob, wanted: { ...kJob.wanted, perPlate: 3 } };
  engine = new RowEngine(job, {
    client: /** @type {any} */ (engine).client_,
    read: async () => ['two'],
    print: async () => undefined,
  });
  answers.batchRow = (/** @type {number} */ index) => ({
    number: index + 1,
    id: `P${index}`,
    text: 't',
    file: 'plate-001.3mf',
    settings: {},
  });
  let described = 0;
  answers.describeRow = () => ({ passed: (described += 1) !== 2, failed: [message('row-without-text')], details: {} });
  answers.exportPlate = new Uint8Array([9]);
  const { rows, file, bytes } = await engine.carve([0, 1, 2], () => false);
  assert.deepEqual([file, [...(bytes ?? [])]], ['plate-001.3mf', [9]]);
  const output = await sha256(new Uint8Array([9]));
  assert.deepEqual(
    rows.map(({ entry }) => [entry.status, entry.sha256.output]),
    [
      ['done', output],
      ['failed', undefined],
      ['done', output],
    ],
  );
  assert.deepEqual(
    calls.filter((call) => /Plate/.test(call)),
    ['startPlate 3', 'addToPlate 0 P0', 'addToPlate 2 P2', 'exportPlate plate-001.3mf'],
  );
  // Each hash covers the whole plate, and the rows' own settings are equal here.
  assert.equal(new Set(rows.map(({ entry }) => entry.sha256.settings)).size, 1);
});
