// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { measured, parseTable, readTables } from './table.js';

const kTable = 'model,level,depth_mm,failed\nplate,0.10,0.250,\nstar,0.10,,no-place\nvase,0.1';

test('a table is read: numbers, words, nothing; the end of a file that is cut off is left out', () => {
  assert.deepEqual(parseTable(kTable), [
    { model: 'plate', level: 0.1, depth_mm: 0.25, failed: null },
    { model: 'star', level: 0.1, depth_mm: null, failed: 'no-place' },
  ]);
  for (let length = 0; length <= kTable.length; ++length) assert.ok(parseTable(kTable.slice(0, length)).length <= 2);
});

test('cases that failed are not measured', () => {
  assert.deepEqual(
    measured(parseTable(kTable)).map(({ model }) => model),
    ['plate'],
  );
});

test('a folder that is not there has no tables', () => {
  assert.deepEqual(readTables('/nowhere'), {});
});
