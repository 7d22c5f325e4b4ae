// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { EngineFailure } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { hint, languages, loadLanguage, sentence } from './words.js';

await loadLanguage('de');

const kWall = message('label-too-deep', { wall: { lengthMm: 0.45 }, depth: { lengthMm: 0.4 } });

test('A message becomes a sentence in each language', () => {
  assert.equal(sentence(kWall), 'The wall under the label is too thin: it leaves 0.45 mm behind a label of 0.4 mm.');
  assert.equal(
    sentence(kWall, 'de'),
    'Die Wand unter der Beschriftung ist zu dünn: hinter einer Beschriftung von 0,4 mm bleiben 0,45 mm.',
  );
  assert.equal(sentence(message('reads-as', { text: { term: 'x' } }), 'en'), 'Reads as x.');
});

test('An error is worded like its message, with its English sentence as text', () => {
  const error = new EngineFailure({ kind: 'BadUsage', ...message('text-empty') });
  assert.deepEqual([error.name, error.message, error.code], ['EngineError', 'The text is empty.', 'text-empty']);
  assert.equal(String(error), 'EngineError: The text is empty.');
  assert.equal(sentence(error, 'de'), 'Der Text ist leer.');
  assert.equal(hint(error), 'Enter the text or link to engrave.');
  assert.equal(hint(error, 'de'), 'Den Text oder Link angeben, der graviert werden soll.');
});

test('A sentence contains that of its cause, and not every message has a hint', () => {
  const why = message('no-graphics', { why: { cause: message('text-empty') } });
  assert.equal(sentence(why), 'The graphics cannot be used: The text is empty.');
  assert.equal(hint(message('no-such-spot', { index: { count: 7 } })), '');
});

test('Other errors keep their own text and have no hint', () => {
  const error = new DOMException('Stopped', 'AbortError');
  assert.deepEqual([sentence(error, 'de'), hint(error)], ['Stopped', '']);
});

test('A language that is unknown or not loaded is refused', async () => {
  assert.throws(() => sentence(kWall, 'xx'), { name: 'RangeError', message: /"xx" is not loaded/ });
  const known = languages.map(({ code }) => code).join(', ');
  await assert.rejects(loadLanguage('xx'), {
    name: 'RangeError',
    message: `There is no language "xx". The languages are ${known}.`,
  });
});
