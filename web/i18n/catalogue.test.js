// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { setLanguage, startTexts, text, textOr } from './catalogue.js';

after(() => setLanguage('en'));

test('a text is in the chosen language', async () => {
  await setLanguage('de');
  assert.equal(text('page.ready'), 'Bereit.');
  await setLanguage('en');
  assert.equal(text('page.ready'), 'Ready.');
});

test('of two languages asked for at once, the later one counts', async () => {
  await Promise.all([setLanguage('de'), setLanguage('en')]);
  assert.equal(text('page.ready'), 'Ready.');
});

test('the texts of an article are loaded, and change with the language', async () => {
  assert.throws(() => text('guide.title'), /no text "guide.title"/);
  await startTexts('guide');
  const english = text('guide.title');
  await setLanguage('de');
  assert.notEqual(text('guide.title'), english);
});

test('a language that cannot be loaded leaves the texts as they are', async () => {
  await setLanguage('en');
  await assert.rejects(setLanguage('xx'));
  assert.equal(text('page.ready'), 'Ready.');
});

test('a text that does not exist is an error, or replaced by another', () => {
  assert.throws(() => text(/** @type {any} */ ('page.nothing')), /no text "page.nothing"/);
  assert.equal(textOr('samples', 'nothing', 'Other'), 'Other');
});
