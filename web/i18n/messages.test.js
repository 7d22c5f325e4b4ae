// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { afterEach, test } from 'node:test';
import { message } from '../engine/message.js';
import { setLanguage } from './catalogue.js';
import { catalogue } from './message_catalogues.js';
import { hintOf, sentenceOf } from './messages.js';
import { isKnownSetting } from './setting_words.js';

const kFolder = new URL('../../messages/', import.meta.url);
// The cases that the command's renderer is tested with, too (tests/messages/sentences_test.cpp), so that the two agree.
const shared = JSON.parse(readFileSync(new URL('../../tests/messages/cases.json', import.meta.url), 'utf8'));
/** The page's words, without the words that only the command uses. */
const kPageWords = JSON.stringify(Object.values(catalogue), (key, value) => (key === 'command' ? undefined : value));

afterEach(() => setLanguage('en'));

test('Sentences and hints match the shared cases in both languages', () => {
  assert.ok(shared.cases.length > 20);
  for (const { message: told, en, de, hint } of shared.cases) {
    setLanguage('en');
    assert.equal(sentenceOf(told, shared.catalogue), en);
    if (hint !== undefined) assert.equal(hintOf(told, shared.catalogue), hint);
    setLanguage('de');
    assert.equal(sentenceOf(told, shared.catalogue), de);
  }
});

test('A setting is named like its control, without the unit', () => {
  const words = {
    thin: {
      en: 'Raise {@minWallMm}, not {which} to {pattern}',
      de: '{@minWallMm} erhöhen, nicht {which} auf {pattern}',
    },
  };
  const raise = message('thin', {
    which: { setting: 'eyeDistanceMm' },
    pattern: { choice: { key: 'pattern', value: 'thin-plus' } },
  });
  assert.equal(sentenceOf(raise, words), 'Raise “Minimum wall”, not “Viewing distance” to Thin plus');
  setLanguage('de');
  assert.equal(sentenceOf(raise, words), '„Restwand“ erhöhen, nicht „Betrachtungsabstand“ auf Dünnes Plus');
});

test('The page has the words of every file of messages/ except the command’s', () => {
  const all = readdirSync(kFolder)
    .filter((name) => name.endsWith('.json') && name !== 'command.json')
    .map((name) => JSON.parse(readFileSync(new URL(name, kFolder), 'utf8')));
  assert.deepEqual(Object.keys(catalogue).sort(), all.flatMap(Object.keys).sort());
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
