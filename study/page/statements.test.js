// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { kStatements } from './statements.js';
import { measured, readTables } from './table.js';

const tables = readTables(new URL('../results', import.meta.url).pathname);

test('every statement can be judged by the kept tables, over something', () => {
  for (const { claim, table, judge } of kStatements) {
    const { holds, of } = judge(measured(tables[table].rows));
    assert.ok(of > 0 && holds >= 0 && holds <= of, `${claim}: ${holds} of ${of}`);
  }
});

test('without rows nothing is counted', () => {
  for (const { claim, judge } of kStatements) assert.deepEqual(judge([]), { holds: 0, of: 0 }, claim);
});

test('every statement leads to a section of the page', () => {
  const page = readFileSync(new URL('../../web/study.html', import.meta.url), 'utf8');
  for (const { section } of kStatements) assert.match(page, new RegExp(`<h2 id="${section}"`));
});
