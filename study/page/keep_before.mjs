// SPDX-License-Identifier: GPL-3.0-or-later
// Copies the tables of the paper's statements, as measured under a depth limit of 1.2 modules, from the history of the
// project into study/results/before/: `node study/page/keep_before.mjs`. The column "Before" of study.html judges them.
import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { kStatements } from './statements.js';

const kCommit = '96364e2b';
const folder = new URL('../results/before/', import.meta.url);

mkdirSync(folder, { recursive: true });
for (const table of new Set(kStatements.map(({ table }) => table))) {
  const csv = execFileSync('git', ['show', `${kCommit}:study/results/${table}.csv`], { cwd: folder });
  writeFileSync(new URL(`${table}.csv`, folder), csv);
}
