// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { after, test } from 'node:test';
import { kLetters } from '../engine/glyphs.js';
import { setLanguage } from './catalogue.js';
import { inspectorTexts } from './inspector_texts.js';

const folder = new URL('../../inspector/', import.meta.url);
const kSources = [...readdirSync(folder), '../viewer/colour_scale.cpp', '../viewer/colour_scale.h'].filter((name) => /\.(cpp|h)$/.test(name));
/** The C++ with neighbouring literals joined, as the compiler does. */
const source = kSources.map((name) => readFileSync(new URL(name, folder), 'utf8')).join('\n').replace(/"\s*\n\s*"/g, '');
const literals = new Set([...source.matchAll(/"((?:[^"\\]|\\.)*)"/g)].map(([, literal]) => literal));
/** Those that are shown as they stand, wherever they are. */
const kShown = /\b(?:translated|phrase|label|write|writeSoftly|fact|plot)\(\s*"((?:[^"\\]|\\.)*)"/g;
/** Names and abbreviations that are the same in every language. */
const kSame = new Set(['', '{}', 'LS', 'AL', 'G', 'L', 'M', 'Q', 'H', 'mm']);
const places = (/** @type {string} */ text) => text.match(/\{[^}]*\}|%d/g) ?? [];

after(() => setLanguage('en'));

test('English is what the module speaks by itself', () => {
  setLanguage('en');
  assert.deepEqual(inspectorTexts(), {});
});

test('Every translation belongs to a text of the inspector, and has its values in the same places', () => {
  setLanguage('de');
  const texts = Object.entries(inspectorTexts());
  assert.ok(texts.length > 100);
  for (const [english, german] of texts) {
    assert.ok(literals.has(english), `no source says "${english}"`);
    assert.deepEqual(places(german), places(english), english);
    assert.notEqual(german, '', english);
  }
});

test('There is a glyph of every letter', () => {
  setLanguage('de');
  const letters = new Set(Object.values(inspectorTexts()).join(''));
  assert.deepEqual([...letters].filter((letter) => !kLetters.includes(letter)), []);
});

test('Every text that the inspector writes is translated', () => {
  setLanguage('de');
  const texts = inspectorTexts();
  const shown = [...source.matchAll(kShown)].map(([, literal]) => literal);
  assert.ok(shown.length > 40);
  assert.deepEqual(shown.filter((text) => !kSame.has(text) && texts[text] === undefined), []);
});

test('So is every channel, and every setting with its group and choices', () => {
  setLanguage('de');
  const texts = inspectorTexts();
  const channels = /kChannels = \{\{([\s\S]*?)\}\};/.exec(source)?.[1] ?? '';
  const named = [...channels.matchAll(/\{"([^"]*)", "([^"]*)"/g)].flatMap(([, name, what]) => [name, what]);
  assert.equal(named.length, 26);
  const overrides = readFileSync(new URL('request_overrides.cpp', folder), 'utf8');
  const choices = [...overrides.matchAll(/constexpr const char\* k\w+\[\] = \{([^}]*)\}/g)]
    .flatMap(([, list]) => [...list.matchAll(/"([^"]*)"/g)].map(([, name]) => name));
  const settings = [...overrides.matchAll(/"(\w[^"]*)",\s+"(\w[^"]*)"/g)].flatMap(([, group, name]) => [group, name]);
  assert.ok(choices.length > 20 && settings.length > 40, `${choices.length} ${settings.length}`);
  assert.deepEqual([...named, ...choices, ...settings].filter((text) => !kSame.has(text) && texts[text] === undefined), []);
});
