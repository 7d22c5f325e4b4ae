// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { after, test } from 'node:test';
import { lettersOf } from '../engine/glyphs.js';
import { setLanguage } from './catalogue.js';
import { inspectorTexts } from './inspector_texts.js';
import { kLanguages } from './locales.js';
import { settingTexts } from './setting_names.js';

const folder = new URL('../../app/inspector/', import.meta.url);
const kSources = [...readdirSync(folder), '../viewer/colour_scale.cpp', '../viewer/colour_scale.h'].filter((name) =>
  /\.(cpp|h)$/.test(name),
);
/** The C++ sources with adjacent string literals joined, as the compiler joins them. */
const source = kSources
  .map((name) => readFileSync(new URL(name, folder), 'utf8'))
  .join('\n')
  .replace(/"\s*\n\s*"/g, '');
const literals = new Set([...source.matchAll(/"((?:[^"\\]|\\.)*)"/g)].map(([, literal]) => literal));
/** Calls that show their literal as it is, wherever they are. */
const kShown = /\b(?:translated|phrase|label|write|writeSoftly|fact|plot)\(\s*"((?:[^"\\]|\\.)*)"/g;
/** Names and abbreviations that are the same in every language. */
const kSame = new Set(['', '{}', 'LS', 'AL', 'G', 'L', 'M', 'Q', 'H', 'mm']);
const places = (/** @type {string} */ text) => text.match(/\{[^}]*\}|%d/g) ?? [];

after(() => setLanguage('en'));

/** Returns the texts that the engine does not get with the settings. */
const ownTexts = async () =>
  Object.fromEntries(Object.entries(await inspectorTexts()).filter(([key]) => !(key in settingTexts())));

test('The English texts equal the module’s own, except for settings', async () => {
  await setLanguage('en');
  assert.deepEqual(await inspectorTexts(), settingTexts());
});

test('Every translation belongs to a text of the inspector and has the same values', async () => {
  await setLanguage('de');
  const texts = Object.entries(await ownTexts());
  assert.ok(texts.length > 80);
  for (const [english, german] of texts) {
    assert.ok(literals.has(english), `no source says "${english}"`);
    assert.deepEqual(places(german), places(english), english);
    assert.notEqual(german, '', english);
  }
});

test('Every letter has a glyph, whatever the language', async () => {
  for (const { code } of kLanguages) {
    await setLanguage(code);
    const texts = Object.values(await inspectorTexts());
    const there = new Set(lettersOf(texts));
    for (const letter of texts.join('')) assert.ok(there.has(letter), `${letter} in ${code}`);
  }
  for (const literal of literals)
    for (const letter of literal) assert.ok(lettersOf([]).includes(letter), `${letter} in "${literal}"`);
});

test('Every text that the inspector writes is translated', async () => {
  await setLanguage('de');
  const texts = await inspectorTexts();
  const literals = [...source.matchAll(kShown)].map(([, literal]) => literal);
  assert.ok(literals.length > 40);
  assert.deepEqual(
    literals.filter((text) => !kSame.has(text) && texts[text] === undefined),
    [],
  );
});

test('Every channel is translated', async () => {
  await setLanguage('de');
  const texts = await inspectorTexts();
  const channels = /kChannels = \{\{([\s\S]*?)\}\};/.exec(source)?.[1] ?? '';
  const named = [...channels.matchAll(/\{"([^"]*)", "([^"]*)"/g)].flatMap(([, name, what]) => [name, what]);
  assert.equal(named.length, 26);
  assert.deepEqual(
    named.filter((text) => !kSame.has(text) && texts[text] === undefined),
    [],
  );
});
