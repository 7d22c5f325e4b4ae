// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { addTexts, allParts, setLanguage, text } from './catalogue.js';
import { kLanguages } from './languages.js';
import { figures } from './parts/figures.js';
import { guide } from './parts/guide.js';
import { method } from './parts/method.js';
import { study } from './parts/study.js';

addTexts({ figures, guide, method, study });

/** @param {unknown} entry  a text, or its forms */
const forms = (entry) => (typeof entry === 'string' ? [entry] : Object.values(/** @type {object} */ (entry)));

/** @param {string} template */
const placeholders = (template) => [...template.matchAll(/\{(\w+)\}/g)].map(([, name]) => name).sort();

for (const [part, languages] of Object.entries(allParts())) {
  test(`all languages of "${part}" have the same texts with the same values, none empty`, () => {
    const { en } = languages;
    for (const language of kLanguages) {
      const there = languages[language];
      assert.deepEqual(Object.keys(there).sort(), Object.keys(en).sort(), language);
      for (const [key, entry] of Object.entries(there)) {
        const expected = new Set(forms(/** @type {any} */ (en)[key]).flatMap(placeholders));
        assert.deepEqual(new Set(forms(entry).flatMap(placeholders)), expected, `${part}.${key} in ${language}`);
        for (const form of forms(entry)) assert.notEqual(form.trim(), '', `${part}.${key} in ${language}`);
      }
    }
  });
}

test('a text is in the chosen language', () => {
  setLanguage('de');
  assert.equal(text('page.ready'), 'Bereit.');
  setLanguage('en');
  assert.equal(text('page.ready'), 'Ready.');
});

test('a text that does not exist is an error', () => {
  assert.throws(() => text(/** @type {any} */ ('page.nothing')), /no text "page.nothing"/);
});
