// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that every file of locales/ is complete.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { kLanguages, load } from './locales.js';
import { partModule } from './locale_plugin.js';

/** @param {string} code */
const read = (code) => JSON.parse(readFileSync(new URL(`../../locales/${code}.json`, import.meta.url), 'utf8'));

/** Texts of the command, of articles and of the file itself, which a language need not have. */
const kElsewhere =
  /^articles\.|^language\.machineMade$|^settings\.settings\.\w+\.(help|without|empty)$|\.command\.|^messages\.command\./;

/**
 * Lists the texts below an object with the values in them.
 * @param {any} texts @param {string} [path]
 * @returns {[path: string, values: string][]}
 */
const listed = (texts, path = '') =>
  Object.entries(texts).flatMap(([key, value]) => {
    const name = path ? `${path}.${key}` : key;
    const forms = typeof value === 'object' && 'other' in value ? Object.values(value) : [value];
    return typeof value === 'object' && !('other' in value) ? listed(value, name) : [[name, valuesOf(forms)]];
  });

/** @param {any[]} forms  "{count}" may be left out of a form, since it chooses the form */
const valuesOf = (forms) => [...new Set(forms.flatMap((form) => form.match(/\{[^}]*\}|%d/g) ?? []))].sort().join(' ');

const english = read('en');
/** The inspector's English texts are its keys. @type {[string, string][]} */
const inspector = Object.keys(read('de').inspector).map((key) => [`inspector.${key}`, valuesOf([key])]);
const needed = new Map([...listed(english), ...inspector].filter(([path]) => !kElsewhere.test(path)));

for (const { code, name } of kLanguages.slice(1))
  test(`${name} has every text of the page, with the same values`, () => {
    const there = new Map(listed(read(code)).filter(([path]) => !kElsewhere.test(path)));
    const faults = [...needed].filter(([path, values]) => there.get(path) !== values).map(([path]) => path);
    assert.deepEqual(faults, []);
    assert.deepEqual(
      [...there.keys()].filter((path) => !needed.has(path)),
      [],
    );
  });

test('No text is empty', () => {
  for (const { code } of kLanguages) assert.doesNotMatch(JSON.stringify(read(code)), /:\s*"\s*"/, code);
});

test('A part has English texts where a language has none, and no words of the command', async () => {
  const [guide, messages, app] = [await load('de', 'guide'), await load('de', 'messages'), await load('en', 'app')];
  assert.deepEqual(Object.keys(guide).sort(), Object.keys(english.articles.guide).sort());
  assert.equal(messages['text-empty'].says, 'Der Text ist leer');
  assert.equal(messages['path-is-folder'], undefined); // the command's
  assert.doesNotMatch(JSON.stringify(messages), /"command":/);
  assert.equal(app.settings.settings.text.help, undefined);
});

test('The page loads a part as a module', async () => {
  const source = partModule('de-app');
  const { default: app } = await import(`data:text/javascript,${encodeURIComponent(source)}`);
  assert.deepEqual(app, await load('de', 'app'));
});
