// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { message } from '../engine/message.js';
import { messageWords } from '../i18n/message_words.js';
import { WorkPanel } from '../ui/work_panel.js';
import { Jobs } from './jobs.js';
import { FakeMessages, Pending, fake, replaced, settled } from './testing.js';

/** @type {FakeMessages} */ let messages;
/** @type {any} */ let panel;
/** @type {boolean[]} */ let busy;
/** @type {Jobs} */ let jobs;

beforeEach(() => {
  messages = new FakeMessages();
  panel = fake(WorkPanel);
  busy = [];
  jobs = new Jobs({ panel, messages: /** @type {any} */ (messages), onBusy: (now) => void busy.push(now) });
});

test('Jobs run one after the other and return their results', async () => {
  const first = new Pending();
  const second = new Pending();
  /** @type {string[]} */ const begun = [];
  const job = (/** @type {string} */ name, /** @type {Pending} */ pending) =>
    jobs.run(
      () => name,
      () => {
        begun.push(name);
        return pending.promise;
      },
    );
  const both = [job('first', first), job('second', second)];
  await settled();
  assert.deepEqual(begun, ['first']);
  first.resolve(1);
  await settled();
  assert.deepEqual(begun, ['first', 'second']);
  second.resolve(2);
  assert.deepEqual(await Promise.all(both), [1, 2]);
  assert.deepEqual(busy, [true, false, true, false]);
});

test('A stage is shown in words once they arrive, with its progress', async () => {
  jobs.showProgress({ stage: message('finding-depth'), fraction: 0.4 });
  await messageWords.load();
  jobs.showProgress({ stage: message('finding-depth'), fraction: 0.5 });
  assert.deepEqual(panel.calls, ['update 0.4 Preparing', 'update 0.5 Finding the depth']);
  assert.match(messages.said[1], /Finding the depth/);
});

test('Cancelling aborts the running job, and a replaced module is not an error', async () => {
  const pending = new Pending();
  /** @type {AbortSignal | undefined} */ let signal;
  const run = jobs.run(
    () => 'work',
    (given) => {
      signal = given;
      return pending.promise;
    },
  );
  await settled();
  jobs.cancel();
  assert.equal(signal?.aborted, true);
  pending.reject(replaced());
  await assert.rejects(run, { code: 'engine-replaced' });
  assert.deepEqual(messages.said.slice(-1), ['Cancelled. The model is unchanged.']);
  assert.equal(jobs.busy, false);
});

test('After a failed job the next one runs', async () => {
  await assert.rejects(
    jobs.run(
      () => 'a',
      async () => {
        throw new Error('no');
      },
    ),
    { message: 'no' },
  );
  assert.equal(
    await jobs.run(
      () => 'b',
      async () => 3,
    ),
    3,
  );
  assert.deepEqual(busy, [true, false, true, false]);
});

test('A job in the background leaves the page free, and the next job waits for it', async () => {
  const background = new Pending();
  const result = jobs.runInBackground(() => background.promise);
  await settled();
  assert.equal(jobs.busy, false);
  assert.deepEqual([busy, panel.calls, messages.said], [[], [], []]);
  let begun = false;
  const next = jobs.run(
    () => 'next',
    async () => void (begun = true),
  );
  await settled();
  assert.equal(begun, false);
  background.resolve(4);
  assert.equal(await result, 4);
  await next;
  assert.equal(begun, true);
});

test('A job in the background can be aborted', async () => {
  /** @type {AbortSignal | undefined} */ let signal;
  const background = new Pending();
  const result = jobs.runInBackground((given) => {
    signal = given;
    return background.promise;
  });
  await settled();
  jobs.abortBackground();
  assert.equal(signal?.aborted, true);
  background.resolve();
  await result;
});
