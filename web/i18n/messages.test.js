// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { afterEach, test } from 'node:test';
import { message } from '../engine/message.js';
import { setLanguage } from './catalogue.js';
import { load } from './locales.js';
import { plainHintOf, plainSentenceOf, sentenceOf } from './messages.js';
import { isKnownSetting } from './setting_words.js';

// The cases that the command's renderer is tested with, too (tests/messages/sentences_test.cpp), so that the two agree.
const shared = JSON.parse(readFileSync(new URL('../../tests/messages/cases.json', import.meta.url), 'utf8'));
const kPageWords = JSON.stringify(await load('en', 'messages'));

afterEach(() => setLanguage('en'));

test('Sentences and hints match the shared cases in both languages', async () => {
  assert.ok(shared.cases.length > 20);
  for (const { message: told, en, hint } of shared.cases) {
    assert.equal(plainSentenceOf(told, shared.words.en), en);
    if (hint !== undefined) assert.equal(plainHintOf(told, shared.words.en), hint);
  }
  await setLanguage('de');
  for (const { message: told, de } of shared.cases) assert.equal(plainSentenceOf(told, shared.words.de), de);
});

test('A setting is named like its control, without the unit', async () => {
  const english = { thin: { says: 'Raise {@minWallMm}, not {which} to {pattern}' } };
  const german = { thin: { says: '{@minWallMm} erhöhen, nicht {which} auf {pattern}' } };
  const raise = message('thin', {
    which: { setting: 'eyeDistanceMm' },
    pattern: { choice: { key: 'pattern', value: 'thin-plus' } },
  });
  assert.equal(sentenceOf(raise, english), 'Raise “Minimum wall”, not “Viewing distance” to Thin plus');
  await setLanguage('de');
  assert.equal(sentenceOf(raise, german), '„Restwand“ erhöhen, nicht „Betrachtungsabstand“ auf Dünnes Plus');
});

test('Every setting that a message names has a name on the page', () => {
  const named = [...kPageWords.matchAll(/\{@(\w+)\}/g)].map(([, key]) => key);
  assert.deepEqual(
    named.filter((key) => !isKnownSetting(key)),
    [],
  );
});

test('No words of the page mention options of the command', () => {
  assert.doesNotMatch(kPageWords, /--[a-z]/);
});

test('The page separates thousands of quantities as the language does; files, coordinates and line numbers do not', async () => {
  const words = { left: { says: '{count} triangles, {part} of them, {size}, at {at}, in line {line}' } };
  const left = message('left', {
    count: { count: 108426 },
    part: { fraction: 0.25 },
    size: { lengthMm: 1234 },
    at: { place: [12345.5, 0, 0] },
    line: { index: 54321 },
  });
  assert.equal(
    plainSentenceOf(left, words),
    '108426 triangles, 25 % of them, 1234 mm, at (12345.5, 0, 0), in line 54321',
  );
  const kept = (/** @type {string} */ said) => said.replaceAll('\u00a0', ' ');
  assert.equal(
    kept(sentenceOf(left, words)),
    '108,426 triangles, 25 % of them, 1,234 mm, at (12345.5, 0, 0), in line 54321',
  );
  await setLanguage('de');
  assert.match(kept(sentenceOf(left, words)), /^108\.426 triangles, 25 % of them, 1\.234 mm, at .*, in line 54321$/);
});
