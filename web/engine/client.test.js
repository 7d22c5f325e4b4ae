// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { afterEach, beforeEach, mock, test } from 'node:test';
import { EngineClient } from './client.js';
import { message } from './message.js';

const settled = async () => {
  for (let i = 0; i < 20; i += 1) await Promise.resolve();
};
const real = {
  Worker: globalThis.Worker,
  OffscreenCanvas: globalThis.OffscreenCanvas,
  HTMLCanvasElement: globalThis.HTMLCanvasElement,
};

/** Hears all requests; answers `start` and `capabilities` at once, and keeps the others in `asked`. */
class FakeWorker {
  /** @type {FakeWorker[]} */ static all = [];
  hears = true;
  constructor() {
    /** @type {{ id: number, verb: string, args: any[] }[]} */ this.asked = [];
    /** @type {(event: any) => void} */ this.onmessage = () => {};
    /** @type {(event: any) => void} */ this.onerror = () => {};
    /** @type {any[]} */ this.canvases = []; // that it was started with
    this.ended = false;
    FakeWorker.all.push(this);
  }
  /** @param {{ id: number, verb: string, args: any[] }} request */
  postMessage(request) {
    if (this.hears) queueMicrotask(() => this.onmessage({ data: { heard: request.id } }));
    const at = { start: undefined, capabilities: { problems: [] } };
    if (request.verb === 'start') this.canvases.push(request.args[0]);
    if (request.verb in at)
      queueMicrotask(() => this.onmessage({ data: { id: request.id, value: /** @type {any} */ (at)[request.verb] } }));
    else this.asked.push(request);
  }
  terminate() {
    this.ended = true;
  }
  /** @param {string} verb @param {{ value?: any, error?: any }} answer */
  answer(verb, answer) {
    const request = this.asked.find((each) => each.verb === verb);
    assert.ok(request, `${verb} was not asked for`);
    this.asked.splice(this.asked.indexOf(request), 1);
    this.onmessage({ data: { id: request.id, ...answer } });
  }
}

/** @type {any[]} */ let events;
let replacements = 0;
/** @type {EngineClient} */ let client;
const worker = () => /** @type {FakeWorker} */ (FakeWorker.all.at(-1));

beforeEach(async () => {
  mock.timers.enable({ apis: ['setTimeout', 'setInterval'] });
  FakeWorker.all = [];
  events = [];
  replacements = 0;
  class Canvas {
    transferControlToOffscreen() {
      return {};
    }
  }
  Object.assign(globalThis, { Worker: FakeWorker, OffscreenCanvas: class {}, HTMLCanvasElement: Canvas });
  client = new EngineClient({
    makeCanvas: () => /** @type {any} */ (new Canvas()),
    onEvent: (event) => void events.push(event),
    onReplaced: () => void (replacements += 1),
  });
  await client.start();
});
afterEach(() => {
  mock.timers.reset();
  Object.assign(globalThis, real);
});

test('Ending rejects pending verbs and starts no other worker', async () => {
  const asked = client.report();
  client.end();
  await assert.rejects(asked, { code: 'engine-replaced' });
  await assert.rejects(client.report(), { code: 'engine-replaced' });
  assert.equal(worker().ended, true);
  assert.deepEqual([FakeWorker.all.length, replacements, events.length], [1, 0, 0]);
});

test('A verb goes to the worker and returns its answer', async () => {
  const picked = client.setCentre({ at: [3, 4] });
  assert.deepEqual(worker().asked[0].args, [{ at: [3, 4] }]);
  worker().answer('setCentre', { value: { hit: false } });
  assert.deepEqual(await picked, { hit: false });
});

test('An error of the engine is thrown with kind, code and values', async () => {
  const placed = client.placement();
  worker().answer('placement', { error: { kind: 'NoSolution', ...message('no-such-spot', { index: { index: 2 } }) } });
  await assert.rejects(placed, {
    name: 'EngineError',
    kind: 'NoSolution',
    code: 'no-such-spot',
    values: { index: { index: 2 } },
  });
});

test('A job reports progress and ends at once when cancelled', async () => {
  const abort = new AbortController();
  /** @type {any[]} */ const heard = [];
  const job = client.engrave({ signal: abort.signal, onProgress: (progress) => void heard.push(progress) });
  worker().onmessage({ data: { event: 'progress', progress: { stage: message('finding-depth'), fraction: 0.5 } } });
  abort.abort();
  assert.equal(await job, undefined);
  assert.equal(heard.length, 1);
  worker().answer('cancel', { value: undefined });
  worker().answer('engrave', { value: null });
  await settled();
  mock.timers.tick(10_000);
  await settled();
  assert.equal(FakeWorker.all.length, 1); // it ended its step in time
});

test('A worker that does not end its step is replaced, and its pending verbs are rejected', async () => {
  const abort = new AbortController();
  const job = client.engrave({ signal: abort.signal, onProgress: () => {} });
  const waiting = client.report();
  abort.abort();
  assert.equal(await job, undefined);
  const stopped = assert.rejects(waiting, { code: 'engine-replaced' });
  mock.timers.tick(4000);
  await stopped;
  await settled();
  assert.deepEqual(
    FakeWorker.all.map(({ ended }) => ended),
    [true, false],
  );
  assert.equal(replacements, 1);
});

test('A silent worker is reported once', async () => {
  client.placement().catch(() => {});
  await settled();
  for (let i = 0; i < 30; i += 1) mock.timers.tick(5000);
  assert.deepEqual(
    events.map(({ event, error }) => [event, error.code, error.values]),
    [['failure', 'engine-hung', { count: { count: 120 } }]],
  );
});

test('An idle worker that does not hear a verb is reported soon', async () => {
  worker().hears = false;
  client.placement().catch(() => {});
  mock.timers.tick(10_000);
  assert.equal(events.length, 0);
  mock.timers.tick(5000);
  assert.deepEqual(
    events.map(({ error }) => [error.code, error.values]),
    [['engine-hung', { count: { count: 15 } }]],
  );
});

test('A worker that is busy with a verb may hear the next one late', async () => {
  client.loadModel(new Uint8Array(1), 'a.stl', 1).catch(() => {});
  await settled();
  worker().hears = false;
  client.placement().catch(() => {});
  for (let i = 0; i < 20; i += 1) mock.timers.tick(5000);
  assert.equal(events.length, 0);
});

test('A broken worker ends every verb with a crash', async () => {
  const both = [client.placement(), client.report()].map((verb) =>
    assert.rejects(verb, { code: 'engine-crashed', values: { detail: { term: 'unreachable' } } }),
  );
  worker().onerror({ preventDefault: () => {}, message: 'unreachable' });
  await Promise.all(both);
  assert.deepEqual(
    events.map(({ error }) => error.code),
    ['engine-crashed'],
  );
});

test('Cancelling while a model is read replaces the worker at once', async () => {
  const abort = new AbortController();
  const loaded = assert.rejects(client.loadModel(new Uint8Array(3), 'a.stl', 1, { signal: abort.signal }), {
    code: 'engine-replaced',
  });
  abort.abort();
  await loaded;
  await settled();
  assert.equal(replacements, 1);
});

test('An idle worker and one that reports progress are never replaced for their silence', async () => {
  for (let i = 0; i < 120; i += 1) mock.timers.tick(5000);
  const job = client.engrave({ signal: new AbortController().signal, onProgress: () => {} });
  await settled();
  for (let i = 0; i < 120; i += 1) {
    mock.timers.tick(5000);
    if (i % 20 === 0)
      worker().onmessage({
        data: { event: 'progress', progress: { stage: message('finding-depth'), fraction: i / 120 } },
      });
  }
  worker().answer('engrave', { value: true });
  assert.equal(await job, true);
  assert.deepEqual(events, []);
  assert.equal(FakeWorker.all.length, 1);
});

test('Without a canvas, the worker starts without graphics', async () => {
  const bare = new EngineClient({ makeCanvas: () => null, onEvent: () => {}, draws: false });
  assert.deepEqual(await bare.start(), { problems: [] });
  assert.deepEqual(worker().canvases, [null]);
});

test('A client that draws nothing goes on without graphics where a worker has no WebGL 2', async () => {
  class WithoutWebGl extends FakeWorker {
    /** @param {{ id: number, verb: string, args: any[] }} request */
    postMessage(request) {
      const error = { kind: 'Internal', ...message('no-webgl2') };
      if (request.verb === 'start' && request.args[0])
        queueMicrotask(() => this.onmessage({ data: { id: request.id, error } }));
      else super.postMessage(request);
    }
  }
  Object.assign(globalThis, { Worker: WithoutWebGl });
  class Canvas {}
  Object.assign(globalThis, { OffscreenCanvas: Canvas });
  const hidden = new EngineClient({
    makeCanvas: () => /** @type {any} */ (new Canvas()),
    onEvent: () => {},
    draws: false,
  });
  assert.deepEqual(await hidden.start(), { problems: [] });
  assert.deepEqual(worker().canvases, [null]);
  assert.equal(FakeWorker.all.at(-2)?.ended, true);
});
