// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { distinct } from './compare.js';
import { kStatements } from './statements.js';
import { measured, readTables } from './table.js';
import { kNeeded } from './tries.js';

const now = readTables(new URL('../results', import.meta.url).pathname);
const before = readTables(new URL('../results/before', import.meta.url).pathname);

test('every statement can be judged by the kept tables, before and now, over equally many cases', () => {
  for (const { claim, table, judge } of kStatements) {
    const [then, here] = [before, now].map((tables) => judge(measured(tables[table].rows)));
    assert.ok(here.of > 0 && here.holds <= here.of, `${claim}: ${here.holds} of ${here.of}`);
    assert.ok(then.of === here.of && then.holds <= then.of, `${claim}: ${then.holds} of ${then.of}`);
  }
});

test('the kept old tables are the tables that the statements use, and have no column with a version', () => {
  assert.deepEqual(Object.keys(before), [...new Set(kStatements.map(({ table }) => table))].sort());
  for (const [table, { csv }] of Object.entries(before)) {
    const head = (/** @type {string} */ text) => text.slice(0, text.indexOf('\n'));
    assert.equal(`${head(csv)},version`, head(now[table].csv), table);
  }
});

test('the paper’s method met the depth limit before, and does not now', () => {
  const limited = [before, now].map((tables) =>
    measured(tables.method_comparison.rows)
      .filter(({ method }) => method === 'papp-2022-whole-modules')
      .map((row) => row.limited),
  );
  assert.ok(limited[0].every((count) => count > 0));
  assert.ok(limited[1].every((count) => count === 0));
});

test('the reasons that name cases are true of the tables', () => {
  const reads = measured(now.pattern_depths.rows).filter(
    ({ modules, finders, designed }) => modules !== 'none' && finders === 'as-modules' && designed >= kNeeded,
  );
  assert.deepEqual(distinct(reads, 'modules'), ['thick-plus']);
});

test('without rows nothing is counted', () => {
  for (const { claim, judge } of kStatements) assert.deepEqual(judge([]), { holds: 0, of: 0 }, claim);
});

test('every statement leads to a section of the page', () => {
  const page = readFileSync(new URL('../../web/study.html', import.meta.url), 'utf8');
  for (const { section } of kStatements) assert.match(page, new RegExp(`<h2 id="${section}"`));
});
