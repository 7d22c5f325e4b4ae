// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { idColumn, textColumn } from './list_preview.js';

/** @param {string[]} names */
const columnsOf = (...names) => names.map((name) => ({ name, cells: ['x'] }));

test('The column of the texts is the one that the plan uses, unless a template makes more of it', () => {
  const columns = columnsOf('Nr', 'URL');
  assert.equal(textColumn({ columns, textNames: ['url'] }, { text: '' }), 'URL');
  assert.equal(textColumn({ columns, textNames: ['Nr'] }, { text: '{Nr}' }), 'Nr');
  assert.equal(textColumn({ columns, textNames: ['Nr'] }, { text: 'https://example.org/{Nr}' }), undefined);
  assert.equal(textColumn({ columns, textNames: ['text'] }, { text: '' }), undefined);
});

test('The ids come from the chosen column, else from one of that name, else they are numbers', () => {
  const columns = columnsOf('ID', 'Part');
  assert.equal(idColumn({ columns }, { id: '' }), 'ID');
  assert.equal(idColumn({ columns }, { id: 'Part' }), 'Part');
  assert.equal(idColumn({ columns: columnsOf('a') }, { id: '' }), undefined);
});
