// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { EngineFailure, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { BatchRun } from './batch_run.js';
import { RowStates } from './row_states.js';

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
    /** @type {number[][]} */ this.units = [];
    FakeEngine.all.push(this);
  }
  async start() {
    if (FakeEngine.failStart) throw FakeEngine.failStart();
  }
  end() {
    this.ended = true;
    this.reject?.(lost());
  }
  /** @param {number[]} unit @param {(index: number) => boolean} looksAtPrint @returns {Promise<any>} */
  carve(unit, looksAtPrint) {
    this.units.push(unit);
    for (const index of unit) this.carved.push([index, looksAtPrint(index)]);
    return new Promise((resolve, reject) => {
      this.finish = (/** @type {'done' | 'failed'} */ status = 'done') =>
        resolve({ rows: unit.map((index) => ({ entry: { number: index + 1, status } })) });
      this.reject = reject;
    });
  }
  get at() {
    return this.carved.at(-1)?.[0];
  }
}

/** @type {RowStates} */ let states;
/** @type {any[]} */ let saved;
/** @type {(() => Error) | undefined} */ let failSave;
let now = 0;

/** @param {number} rows @param {Partial<import('./batch_run.js').BatchRunOptions>} [options] */
function runOf(rows, options = {}) {
  states = new RowStates(rows);
  return new BatchRun({
    states,
    engines: 2,
    printEvery: 3,
    perPlate: 0,
    onChange: () => {},
    now: () => now,
    makeEngine: () => /** @type {any} */ (new FakeEngine()),
    save: async (carved) => {
      if (failSave) throw failSave();
      saved.push(...carved.rows.map(({ entry }) => entry.number));
      return carved.rows.map(({ entry }) => (entry.status === 'failed' ? 'it does not read' : ''));
    },
    saveLost: async (indices, { code }) => {
      saved.push(...indices.map((index) => `${index + 1} ${code}`));
      return indices.map(() => code);
    },
    ...options,
  });
}

const engines = () => FakeEngine.all;
const statesOf = () => Array.from({ length: states.size }, (_, index) => states.of(index));
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

test('Two engines share the rows, carve and store each once, and simulate every nth print', async () => {
  const run = runOf(7);
  await finishAll(run.run());
  assert.deepEqual(states.counts, { waiting: 0, running: 0, done: 7, failed: 0 });
  assert.deepEqual([...saved].sort(), [1, 2, 3, 4, 5, 6, 7]);
  const printed = engines()
    .flatMap(({ carved }) => carved)
    .filter(([, looks]) => looks)
    .map(([index]) => index);
  assert.deepEqual(printed.sort(), [0, 3, 6]);
  assert.equal(engines().length, 2);
  assert.ok(engines().every(({ ended, carved }) => ended && carved.length > 1));
});

test('Starts no more engines than rows', async () => {
  await finishAll(runOf(1).run());
  assert.equal(engines().length, 1);
});

test('A failed row does not stop the others, and its reason is stored', async () => {
  const run = runOf(3, { engines: 1 });
  const ran = run.run();
  await settled();
  engines()[0].finish?.('failed');
  await finishAll(ran);
  assert.deepEqual(statesOf(), ['failed', 'done', 'done']);
  assert.equal(states.reasonOf(0), 'it does not read');
});

test('Rows that are already carved are skipped', async () => {
  const run = runOf(3, { engines: 1 });
  states.set(0, 'done');
  states.set(1, 'failed', 'as before');
  await finishAll(run.run());
  assert.deepEqual(engines()[0].carved, [[2, false]]);
  assert.equal(states.reasonOf(1), 'as before');
});

test('While paused, running rows finish and no other starts', async () => {
  const run = runOf(4);
  const ran = run.run();
  await settled();
  run.pause();
  engines().forEach((engine) => engine.finish?.());
  await settled();
  assert.deepEqual(statesOf(), ['done', 'done', 'waiting', 'waiting']);
  run.resume();
  await finishAll(ran);
  assert.equal(states.counts.done, 4);
});

test('After the end, running rows count as not started', async () => {
  const run = runOf(4);
  const ran = run.run();
  await settled();
  engines()[0].finish?.();
  await settled();
  run.end();
  await ran;
  assert.deepEqual(statesOf(), ['done', 'waiting', 'waiting', 'waiting']);
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
  assert.equal(states.counts.waiting, 4);
});

test('A lost engine is replaced, and the next one carves its row', async () => {
  const run = runOf(2, { engines: 1 });
  const ran = run.run();
  await settled();
  engines()[0].reject?.(lost());
  await finishAll(ran);
  assert.deepEqual(statesOf(), ['done', 'done']);
  assert.equal(engines().length, 2);
  assert.equal(engines()[0].ended, true);
});

test('A row that loses two engines fails, with its own line', async () => {
  const run = runOf(2, { engines: 1 });
  const ran = run.run();
  for (let losses = 0; losses < 2; losses += 1) {
    await settled();
    engines().at(-1)?.reject?.(lost());
  }
  await finishAll(ran);
  assert.deepEqual(statesOf(), ['failed', 'done']);
  assert.deepEqual(saved, ['1 engine-crashed', 2]);
});

test('A storage failure ends the batch with the reason, and the row stays open', async () => {
  const run = runOf(3, { engines: 1 });
  failSave = full;
  await finishAll(run.run());
  assert.equal(run.problem?.code, 'storage-full');
  assert.deepEqual(statesOf(), ['waiting', 'waiting', 'waiting']);
});

test('If no engine starts, the batch ends with the reason', async () => {
  FakeEngine.failStart = () => new EngineFailure(internal(message('no-graphics')));
  const run = runOf(3);
  await run.run();
  assert.equal(run.problem?.code, 'no-graphics');
  assert.equal(states.counts.waiting, 3);
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
  assert.equal(states.counts.done, 3);
});

test('The remaining time follows from the pace so far, without pauses', async () => {
  const run = runOf(5, { engines: 1 });
  const ran = run.run();
  await settled();
  assert.equal(run.remainingMs, undefined);
  now = 1000;
  engines()[0].finish?.();
  await settled();
  assert.equal(run.remainingMs, 4000);
  run.pause();
  now = 100_000;
  assert.equal(run.remainingMs, 4000);
  run.resume();
  await finishAll(ran);
});

test('The rows of a plate are carved together, all of them if one is new', async () => {
  const run = runOf(8, { engines: 1, perPlate: 3 });
  for (const index of [0, 1, 2, 4]) states.set(index, 'done');
  await finishAll(run.run());
  assert.deepEqual(engines()[0].units, [
    [3, 4, 5],
    [6, 7],
  ]);
  assert.equal(states.counts.done, 8);
  assert.deepEqual(saved, [4, 5, 6, 7, 8]);
});
