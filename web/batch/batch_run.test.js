// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { EngineFailure, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { BatchRun } from './batch_run.js';
import { FakeTracker } from './testing.js';

const settled = () =>
  new Promise((resolve) => {
    setImmediate(resolve);
  });
const lost = () => new EngineFailure(internal(message('engine-crashed', { detail: { term: 'unreachable' } })));
const full = () => new EngineFailure(internal(message('storage-full')));

/** Holds each row until the test finishes it. */
class FakeEngine {
  /** @type {FakeEngine[]} */ static all = [];
  /** @type {(() => Error) | undefined} */ static failStart;
  constructor() {
    this.ended = false;
    /** @type {[number, boolean][]} */ this.carved = [];
    FakeEngine.all.push(this);
  }
  async start() {
    if (FakeEngine.failStart) throw FakeEngine.failStart();
  }
  end() {
    this.ended = true;
    this.reject?.(lost());
  }
  /** @param {import('../engine/types.js').RowToCarve[]} unit @param {(rows: number) => void} tell @returns {Promise<any>} */
  carve(unit, tell) {
    this.tell = tell;
    for (const { index, print } of unit) this.carved.push([index, print]);
    return new Promise((resolve, reject) => {
      this.finish = (/** @type {'done' | 'failed'} */ status = 'done') =>
        resolve({ rows: unit.map(({ index }) => ({ entry: { number: index + 1, status } })) });
      this.reject = reject;
    });
  }
  get at() {
    return this.carved.at(-1)?.[0];
  }
}

/** @type {FakeTracker} */ let tracker;
/** @type {any[]} */ let saved;
/** @type {(() => Error) | undefined} */ let failSave;
let now = 0;

/** @param {number} rows @param {Partial<import('./batch_run.js').BatchRunOptions>} [options] */
function runOf(rows, options = {}) {
  tracker = new FakeTracker(rows);
  return new BatchRun({
    tracker,
    engines: 2,
    onChange: () => {},
    now: () => now,
    makeEngine: () => /** @type {any} */ (new FakeEngine()),
    save: async (carved) => {
      if (failSave) throw failSave();
      saved.push(...carved.rows.map(({ entry }) => entry.number));
      return carved.rows.map(({ entry }) => JSON.stringify(entry)).join('\n');
    },
    saveLost: async ([{ index }], { code }) => {
      saved.push(`${index + 1} ${code}`);
      return JSON.stringify({ number: index + 1, status: 'failed' });
    },
    ...options,
  });
}

const engines = () => FakeEngine.all;
const statesOf = () => tracker.states.map((state) => state[0]).join('');
/** Finishes all rows. @param {Promise<void>} ran */
async function finishAll(ran) {
  let over = false;
  void ran.then(() => {
    over = true;
  });
  for (let turns = 0; !over && turns < 100; turns += 1) {
    await settled();
    engines()
      .filter(({ ended }) => !ended)
      .forEach((engine) => engine.finish?.());
  }
  await ran;
}

beforeEach(() => {
  FakeEngine.all = [];
  FakeEngine.failStart = undefined;
  saved = [];
  failSave = undefined;
  now = 0;
});

test('Two engines share the rows, and carve and store each once', async () => {
  await finishAll(runOf(7).run());
  assert.equal(statesOf(), 'ddddddd');
  assert.deepEqual([...saved].sort(), [1, 2, 3, 4, 5, 6, 7]);
  const printed = engines()
    .flatMap(({ carved }) => carved)
    .filter(([, looks]) => looks)
    .map(([index]) => index);
  assert.deepEqual(printed, [0]);
  assert.equal(engines().length, 2);
  assert.ok(engines().every(({ ended, carved }) => ended && carved.length > 1));
});

test('Starts no more engines than rows', async () => {
  await finishAll(runOf(1).run());
  assert.equal(engines().length, 1);
});

test('Rows count in part while they are carved, and no longer once they are settled or given up', async () => {
  let told = 0;
  const run = runOf(3, { onProgress: () => void (told += 1) });
  const ran = run.run();
  await settled();
  const [first, second] = engines();
  first.tell?.(0.25);
  second.tell?.(0.25);
  second.tell?.(0.5);
  assert.deepEqual([run.partly, told], [0.75, 3]);
  first.finish?.();
  await settled();
  assert.equal(run.partly, 0.5, 'the first is settled');
  run.end();
  second.tell?.(0.75);
  await ran;
  assert.deepEqual([run.partly, told], [0, 3]);
});

test('A failed row does not stop the others', async () => {
  const ran = runOf(3, { engines: 1 }).run();
  await settled();
  engines()[0].finish?.('failed');
  await finishAll(ran);
  assert.equal(statesOf(), 'fdd');
});

test('While paused, running rows finish and no other starts', async () => {
  const run = runOf(4);
  const ran = run.run();
  await settled();
  run.pause();
  engines().forEach((engine) => engine.finish?.());
  await settled();
  assert.equal(statesOf(), 'ddww');
  run.resume();
  await finishAll(ran);
  assert.equal(statesOf(), 'dddd');
});

test('After the end, running rows wait again', async () => {
  const run = runOf(4);
  const ran = run.run();
  await settled();
  engines()[0].finish?.();
  await settled();
  run.end();
  await ran;
  assert.equal(statesOf(), 'dwww');
  assert.equal(run.problem, undefined);
  assert.ok(engines().every(({ ended }) => ended));
});

test('A paused batch can be ended', async () => {
  const run = runOf(4);
  const ran = run.run();
  await settled();
  run.pause();
  run.end();
  await ran;
  assert.equal(statesOf(), 'wwww');
});

test('A lost engine is replaced, and the next one carves its row', async () => {
  const ran = runOf(2, { engines: 1 }).run();
  await settled();
  engines()[0].reject?.(lost());
  await finishAll(ran);
  assert.equal(statesOf(), 'dd');
  assert.equal(engines().length, 2);
  assert.equal(engines()[0].ended, true);
});

test('A row that fails by losing engines gets its own line', async () => {
  const ran = runOf(2, { engines: 1 }).run();
  tracker.reactions = ['retry', 'fail'];
  for (let losses = 0; losses < 2; losses += 1) {
    await settled();
    engines().at(-1)?.reject?.(lost());
  }
  await finishAll(ran);
  assert.equal(statesOf(), 'fd');
  assert.deepEqual(saved, ['1 engine-crashed', 2]);
});

test('Too many losses end the batch with the reason', async () => {
  const run = runOf(2, { engines: 1 });
  tracker.reactions = ['stop'];
  const ran = run.run();
  await settled();
  engines()[0].reject?.(lost());
  await ran;
  assert.equal(run.problem?.code, 'engine-crashed');
  assert.equal(statesOf(), 'ww');
});

test('A storage failure ends the batch with the reason, and the row stays open', async () => {
  const run = runOf(3, { engines: 1 });
  failSave = full;
  await finishAll(run.run());
  assert.equal(run.problem?.code, 'storage-full');
  assert.equal(statesOf(), 'www');
});

test('If no engine starts, the batch ends with the reason', async () => {
  FakeEngine.failStart = () => new EngineFailure(internal(message('no-graphics')));
  const run = runOf(3);
  await run.run();
  assert.equal(run.problem?.code, 'no-graphics');
  assert.equal(statesOf(), 'www');
});

test('If engines are lost before they start, the tracker says when to end', async () => {
  FakeEngine.failStart = lost;
  const run = runOf(3, { engines: 1 });
  tracker.reactions = ['retry', 'stop'];
  await run.run();
  assert.equal(run.problem?.code, 'engine-crashed');
  assert.equal(engines().length, 2);
});

test('If the second engine does not start, the first carves all rows', async () => {
  const run = runOf(3, {
    makeEngine: () => {
      const engine = new FakeEngine();
      if (engines().length === 2)
        engine.start = async () => {
          throw new EngineFailure(internal(message('out-of-memory')));
        };
      return /** @type {any} */ (engine);
    },
  });
  await finishAll(run.run());
  assert.equal(run.problem, undefined);
  assert.equal(statesOf(), 'ddd');
});

test('The run’s time excludes pauses', async () => {
  const run = runOf(5, { engines: 1 });
  const ran = run.run();
  await settled();
  now = 1000;
  assert.equal(run.workedMs, 1000);
  run.pause();
  now = 100_000;
  assert.equal(run.workedMs, 1000);
  run.resume();
  now = 100_500;
  assert.equal(run.workedMs, 1500);
  await finishAll(ran);
});
