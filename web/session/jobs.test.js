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

test('One job runs after the other, and what it gives is handed on', async () => {
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

test('A stage is told in words as soon as they are there, with how far it has come', async () => {
  jobs.showProgress({ stage: message('finding-depth'), fraction: 0.4 });
  await messageWords.come();
  jobs.showProgress({ stage: message('finding-depth'), fraction: 0.5 });
  assert.deepEqual(panel.calls, ['update 0.4 Preparing', 'update 0.5 Finding the depth']);
  assert.match(messages.said[1], /Finding the depth/);
});

test('Cancelling aborts what runs, and that the module was replaced for it is no fault to tell', async () => {
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

test('A job that fails leaves the next one free to run', async () => {
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
