// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { EngineFailure, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { kReaderName } from '../decoder/reader.js';
import { Carver } from './carver.js';
import { sha256 } from './hashes.js';
import { RowEngine } from './row_engine.js';

const kDone = { needs: null, carving: 7, changes: [] };
const kJob = /** @type {any} */ ({
  model: { bytes: new Uint8Array(3), fileName: 'cube.stl', scaleToMm: 25.4, upAxis: 'y' },
  input: 'aa',
  centreMm: [1, 2, 3],
  list: new Uint8Array(),
  request: { settings: { text: '', preset: 'balanced' }, text: '', name: '', count: 2, perPlate: 0 },
});

/** @type {string[]} */ let calls;
/** @type {any[]} */ let options; // of the engravings
/** @type {any[]} */ let read; // what the engraving goes on with
/** @type {any[]} */ let configured;
/** @type {any[]} */ let placements; // of the texts to hash
/** @type {any[]} */ let steps; // what the engraving needs, one after the other
/** @type {any} */ let answers;
/** @type {RowEngine} */ let engine;
/** Carves the second row. @param {boolean} looks */
const carveSecond = async (looks = false) => {
  const {
    rows: [row],
    files,
  } = await engine.carve([{ index: 1, print: looks }], () => {});
  return { ...row, files };
};

beforeEach(() => {
  calls = [];
  read = [];
  configured = [];
  placements = [];
  options = [];
  steps = [{ needs: 'texts', carving: 7, pictures: [] }, kDone];
  answers = {
    start: { problems: [] },
    batchRow: { number: 2, line: 3, id: 'b', text: 'two', file: 'b.3mf', settings: { text: 'two', version: 1 } },
    unitTexts: (/** @type {number} */ _, /** @type {any} */ placed) => {
      placements.push(placed);
      return placed.of === 'plate' ? [] : ['hash me'];
    },
    unitEntries: (/** @type {number} */ _, /** @type {any} */ { input, settings: [settings] }) => [
      { number: 2, id: 'b', text: 'two', file: 'b.3mf', status: 'failed', sha256: { input, settings } },
    ],
    engrave: () => steps.shift(),
    continueEngrave: () => steps.shift(),
    configure: (/** @type {any} */ settings) => void configured.push(settings),
    describeRow: { passed: true, failed: [], details: { grades: 'A' } },
    exportFiles: (/** @type {string} */ name) => [{ name, bytes: new Uint8Array([1, 2]) }],
    printJob: { order: {}, stl: new Uint8Array() },
    setPrintedReadings: { passed: true },
  };
  const client = new Proxy(
    {},
    {
      get:
        (_, name) =>
        async (/** @type {any[]} */ ...args) => {
          calls.push([name, ...args.filter((arg) => typeof arg !== 'object')].join(' '));
          if (name === 'engrave') options.push(args[0].options);
          if (name === 'continueEngrave') read.push(args[0].read);
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
  assert.deepEqual(calls, ['start', 'show', 'loadModel cube.stl 25.4', 'planBatch', 'setCentre']);
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
  const placed = { centre: [1, 2, 3], others: '25.4 y', mates: [] };
  assert.deepEqual(placements, [
    { of: 'plate', ...placed },
    { of: 'rows', ...placed },
  ]);
  assert.deepEqual(carved.files, [{ name: 'b.3mf', bytes: new Uint8Array([1, 2]) }]);
  assert.ok(!calls.includes('printJob'));
});

test('Decodes what the engraving shows, and simulates its print if it needs one', async () => {
  steps = [{ needs: 'texts', carving: 7, pictures: [] }, { needs: 'print', carving: 7 }, kDone];
  await carveSecond(true);
  assert.deepEqual(options, [{ print: true }]);
  assert.deepEqual(read, [{ texts: ['two'], reader: kReaderName }, undefined]);
  assert.ok(calls.includes('setPrintedReadings 7 12'));
});

test('The settings of the result are those as asked for with its changes', async () => {
  const changes = [
    { setting: 'preset', value: 'robust' },
    { setting: 'maxSizeMm', value: '80' },
  ];
  steps = [{ ...kDone, changes }];
  const carver = new Carver({ client: /** @type {any} */ (engine).client_ });
  const job = { signal: new AbortController().signal, onProgress: () => {} };
  const settings = await carver.carve(/** @type {any} */ ({ text: 'a', preset: 'balanced' }), true, job);
  assert.deepEqual(settings, { text: 'a', preset: 'robust', maxSizeMm: 80 });
});

test('Progress goes on through the print and never goes back', async () => {
  const stage = message('finding-depth');
  answers.engrave = (/** @type {any} */ { onProgress }) => {
    onProgress({ stage, fraction: 0.5 });
    return { needs: 'print', carving: 7 };
  };
  answers.continueEngrave = (/** @type {any} */ { onProgress }) => {
    onProgress({ stage, fraction: 0.55 });
    return kDone;
  };
  const carver = new Carver({
    client: /** @type {any} */ (engine).client_,
    read: async () => [],
    print: async (_, { onProgress }) => {
      for (const fraction of [0, 1]) onProgress(fraction);
      return /** @type {any} */ ({ pictures: [], facingDeg: 0 });
    },
  });
  /** @type {number[]} */ const told = [];
  await carver.carve(/** @type {any} */ ({}), true, {
    signal: new AbortController().signal,
    onProgress: ({ fraction }) => told.push(fraction),
  });
  assert.deepEqual(told, [0.5, 0.5, 0.6, 0.6]);
});

test('A row fails with the engine if an engraving does not go on', async () => {
  steps = [{ needs: 'texts', carving: 7, pictures: [] }];
  answers.continueEngrave = new EngineFailure(internal(message('engine-hung')));
  await assert.rejects(carveSecond(), { code: 'engine-hung' });
});

test('A row with failed checks has no file and names the checks', async () => {
  answers.describeRow = { passed: false, failed: [message('row-without-text')], details: { grades: 'F' } };
  const carved = await carveSecond();
  assert.deepEqual(
    [carved.entry.status, /** @type {any} */ (carved.entry).grades, carved.why?.code, carved.files],
    ['failed', 'F', 'row-without-text', []],
  );
});

test('A row that cannot be carved fails; a broken engine is reported', async () => {
  answers.engrave = new EngineFailure({ kind: 'NoSolution', ...message('no-centre') });
  const carved = await carveSecond();
  assert.deepEqual([carved.entry.status, carved.why?.code], ['failed', 'no-centre']);
  answers.engrave = new EngineFailure(internal(message('engine-crashed', { detail: { term: 'unreachable' } })));
  await assert.rejects(carveSecond(), { code: 'engine-crashed' });
});

test('A row with a second file has both files and both hashes', async () => {
  const written = [
    { name: 'b.stl', bytes: new Uint8Array([1]) },
    { name: 'b-2.stl', bytes: new Uint8Array([2]) },
  ];
  answers.exportFiles = () => written;
  const { entry, files } = await carveSecond();
  assert.deepEqual(files, written);
  const [output, second] = await Promise.all(written.map(({ bytes }) => sha256(bytes)));
  assert.deepEqual(entry.sha256, { input: 'aa', settings: await sha256('hash me'), output, second });
  assert.equal(entry.second, 'b-2.stl');
});

test('A row whose file cannot be written fails', async () => {
  answers.exportFiles = new EngineFailure(internal(message('model-not-written', { format: { term: 'STL' } })));
  const carved = await carveSecond();
  assert.deepEqual([carved.entry.status, carved.why?.code, carved.files], ['failed', 'model-not-written', []]);
});

test('Rows of a plate share its file, without those that failed', async () => {
  const job = { ...kJob, request: { ...kJob.request, perPlate: 3 } };
  engine = new RowEngine(job, {
    client: /** @type {any} */ (engine).client_,
    read: async () => ['two'],
    print: async () => undefined,
  });
  answers.unitTexts = (/** @type {number} */ _, /** @type {any} */ { of, mates }) =>
    [0, 1, 2].map((index) => `${of} ${index} ${mates}`);
  answers.unitEntries = (/** @type {number} */ _, /** @type {any} */ { settings }) =>
    [0, 1, 2].map((index) => ({
      number: index + 1,
      id: `P${index}`,
      file: 'plate-001.3mf',
      status: 'failed',
      sha256: { input: 'aa', settings: settings[index] },
    }));
  let described = 0;
  answers.engrave = (/** @type {any} */ { onProgress }) => {
    onProgress({ stage: message('finding-depth'), fraction: 0.5 });
    return kDone;
  };
  /** @type {number[]} */ const progress = [];
  answers.describeRow = () => ({ passed: (described += 1) !== 2, failed: [message('row-without-text')], details: {} });
  answers.exportPlate = new Uint8Array([9]);
  const { rows, files } = await engine.carve(
    [0, 1, 2].map((index) => ({ index, print: false })),
    (/** @type {number} */ carved) => void progress.push(carved),
  );
  assert.deepEqual(files, [{ name: 'plate-001.3mf', bytes: new Uint8Array([9]) }]);
  assert.deepEqual(progress, [0.5, 1.5, 2.5]);
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
    ['addToPlate 0 P0 3', 'addToPlate 2 P2 3', 'exportPlate plate-001.3mf'],
  );
  const mates = await Promise.all([0, 1, 2].map((index) => sha256(`plate ${index} `)));
  assert.equal(rows[1].entry.sha256.settings, await sha256(`rows 1 ${mates}`));
});
