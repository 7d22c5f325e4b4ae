// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { Recovery } from './recovery.js';
import { EngineFailure, hung, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { messageWords } from '../i18n/message_words.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';
import { FakeMessages, Pending, crashed, noRoom, replaced, settled } from './testing.js';

/** @type {FakeMessages} */ let messages;
let replacements = 0;
/** @type {() => Promise<void>} */ let replace;
/** @type {Recovery} */ let recovery;

beforeEach(() => {
  messages = new FakeMessages();
  replacements = 0;
  replace = async () => void (replacements += 1);
  recovery = new Recovery(/** @type {any} */ (messages), () => replace());
});

test('An error is shown, and the module stays', async () => {
  await recovery.guard(async () => {
    throw noRoom();
  });
  assert.equal(messages.problem?.code, 'no-centre');
  assert.equal(replacements, 0);
});

test('A bug is shown with its text', async () => {
  await recovery.guard(async () => {
    throw new TypeError('x is no function');
  });
  assert.equal(messages.problem?.code, 'internal-fault');
  assert.equal(messages.problem.values.detail.term, 'x is no function');
});

test('Work that ended because of a replaced module shows nothing', async () => {
  await recovery.guard(async () => {
    throw replaced();
  });
  assert.equal(messages.problem, undefined);
  assert.deepEqual(messages.said, []);
});

test('A broken module is replaced once for all pending work', async () => {
  const replacing = new Pending();
  replace = () => {
    replacements += 1;
    return replacing.promise;
  };
  const both = [
    recovery.guard(async () => {
      throw crashed();
    }),
    recovery.guard(async () => {
      throw crashed();
    }),
  ];
  await settled();
  assert.equal(replacements, 1);
  replacing.resolve();
  await Promise.all(both);
  assert.ok(messages.said.some((words) => /Restarting/.test(words)));
});

test('Lost graphics are rebuilt without an error', async () => {
  await recovery.recoverFrom({ event: 'contextlost' });
  assert.equal(replacements, 1);
  assert.equal(messages.problem, undefined);
});

test('After three replacements in a short time the page gives up and gives advice', async () => {
  for (let i = 0; i < 4; i += 1) await recovery.recoverFrom({ event: 'contextlost' });
  assert.equal(replacements, 3);
  assert.notEqual(messages.problem.help(), '');
});

test('A module that hangs or runs out of memory is replaced, with the matching message', async () => {
  await messageWords.load();
  const error = hung(120_000);
  await recovery.recoverFrom({ event: 'failure', error });
  assert.equal(replacements, 1);
  assert.match(sentenceOf(messages.problem), /has not answered for 120 seconds/);
  assert.notEqual(hintOf(messages.problem), '');
  await recovery.guard(async () => {
    throw new EngineFailure(internal(message('out-of-memory')));
  });
  assert.equal(replacements, 2);
  assert.match(sentenceOf(messages.problem), /no more memory/);
});
