// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { gainsAtPlaces } from '../figures/guaranteed_size.js';
import { carving, tolerates } from '../figures/light_angles.js';
import { distinct } from './compare.js';
import { ofSearch } from './methods.js';
import { kStatements } from './statements.js';
import { measured, readTables } from './table.js';
import { kNeeded } from './tries.js';

const tables = readTables(new URL('../results', import.meta.url).pathname);

test('every statement can be judged by the kept tables', () => {
  for (const { claim, table, judge } of kStatements) {
    const { holds, of } = judge(measured(tables[table].rows));
    assert.equal(of > 0, claim !== 'claimThickModule', claim); // thin pluses never decode, so nothing can be compared
    assert.ok(holds <= of, `${claim}: ${holds} of ${of}`);
  }
});

test('no depth limit stops the paper’s method', () => {
  const limited = measured(tables.method_comparison.rows)
    .filter(({ method }) => method === 'papp-2022-whole-modules')
    .map((row) => row.limited);
  assert.ok(limited.every((count) => count === 0));
});

test('the reasons that name cases are true of the tables', () => {
  const reads = ofSearch(measured(tables.pattern_depths.rows)).filter(
    ({ modules, finders, designed }) => modules !== 'none' && finders === 'as-modules' && designed >= kNeeded,
  );
  assert.deepEqual(distinct(reads, 'modules'), ['thick-plus']);

  const gains = gainsAtPlaces(measured(tables.random_sizes.rows));
  const [larger, smaller] = [gains.filter((gain) => gain >= 0.02), gains.filter((gain) => gain <= -0.02)];
  assert.ok(
    larger.length < 1.5 * smaller.length && smaller.length < 1.5 * larger.length,
    `${larger.length}, ${smaller.length}`,
  );

  const thin = measured(tables.least_module.rows).filter(({ modules }) => modules === 'thin-plus');
  assert.ok(thin.length > 0 && thin.every((row) => row.module_mm === null));

  const sizes = measured(tables.least_module.rows);
  const whole = new Map(
    sizes
      .filter(({ finders }) => finders === 'none')
      .map((row) => [[row.process, row.pose, row.modules].join(' '), row.module_mm]),
  );
  for (const { process, pose, modules, finders, module_mm: mm } of sizes) {
    const ofWhole = whole.get([process, pose, modules].join(' ')) ?? Infinity;
    if (mm === null || mm >= ofWhole) continue;
    if (finders === 'diamond') assert.ok(pose === 'code-upright' && ['square', 'diamond'].includes(modules));
    if (finders === 'thick-plus') assert.ok(mm > 0.88 * ofWhole, `${process} ${pose} ${modules}`);
  }

  const angles = ofSearch(measured(tables.light_angles.rows));
  const lowLamp = carving(angles, 'none', 8);
  assert.deepEqual(
    [7, 15].map((higher) => tolerates(lowLamp, 8, higher)),
    [true, false],
  );
  const unread = carving(angles, 'none', 33).filter((row) => row.read_at < 33 && row.reads < kNeeded);
  assert.deepEqual(
    unread.map((row) => row.read_at),
    [4, 8],
  );
  for (const lamp of [8, 33]) assert.ok(tolerates(carving(angles, 'square', lamp), lamp, 0));
});

test('without rows nothing is counted', () => {
  for (const { claim, judge } of kStatements) assert.deepEqual(judge([]), { holds: 0, of: 0 }, claim);
});

test('every statement leads to a section of the page', () => {
  const page = readFileSync(new URL('../../web/study.html', import.meta.url), 'utf8');
  for (const { section } of kStatements) assert.match(page, new RegExp(`<h3 id="${section}"`));
});
