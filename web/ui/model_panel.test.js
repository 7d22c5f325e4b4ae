// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fileToOpen } from './model_panel.js';

test('Of several files the model is opened, else the first file', () => {
  const nameOf = (/** @type {string[]} */ ...names) =>
    fileToOpen(
      names.map((name) => new File([''], name)),
      '.stl,.obj,.json',
    ).name;
  assert.equal(nameOf('vase.mtl', 'wood.png', 'Vase.OBJ'), 'Vase.OBJ');
  assert.equal(nameOf('settings.json', 'b.stl', 'a.stl'), 'b.stl');
  assert.equal(nameOf('list.csv', 'more.csv'), 'list.csv');
});
