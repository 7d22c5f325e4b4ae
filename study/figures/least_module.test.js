// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { asSmall, leastOf, wholeAsSmallAsModules, wholeAsSmallAsOwn } from './least_module.js';

const row = (/** @type {string} */ modules, /** @type {string} */ pose, /** @type {number | null} */ mm) => ({
  process: 'fdm-0.4/0.2',
  modules,
  finders: 'none',
  pose,
  module_mm: mm,
});

test('the least module is of those that read', () => {
  const rows = [row('none', 'code-up', null), row('none', 'code-upright', 0.7), row('square', 'code-up', 0.6)];
  assert.equal(leastOf(rows)?.module_mm, 0.6);
  assert.equal(leastOf([row('none', 'code-up', null)]), undefined);
});

test('values of a column are compared with all else the same; what never reads needs the largest, and two such tell nothing', () => {
  const rows = [
    row('none', 'code-up', 0.7),
    row('none', 'code-upright', 0.6),
    row('square', 'code-up', null),
    row('square', 'code-upright', 0.9),
    row('diamond', 'code-up', null),
    row('diamond', 'code-upright', null),
    row('thin-plus', 'code-up', 0.6),
    row('thin-plus', 'code-upright', null),
  ];
  assert.deepEqual(asSmall(rows, 'pose', 'code-upright', 'code-up'), { holds: 2, of: 3 });
});

test('whole finders are compared with both of the paper’s, and with the modules’ pattern where there is one', () => {
  const sizes = (/** @type {string} */ modules, /** @type {Record<string, number | null>} */ byFinders) =>
    Object.entries(byFinders).map(([finders, mm]) => ({ ...row(modules, 'code-up', mm), finders }));
  const rows = [
    ...sizes('none', { none: 0.5, 'as-modules': 0.5, diamond: 0.6, 'thick-plus': 0.5, 'thick-plus-sharp': 0.4 }),
    ...sizes('square', { none: 0.6, 'as-modules': null, diamond: 0.5, 'thick-plus': null }),
    ...sizes('diamond', { none: 0.7, 'as-modules': 0.6, diamond: null, 'thick-plus': 0.6 }),
    ...sizes('thin-plus', { none: null, 'as-modules': null, diamond: null, 'thick-plus': null }),
  ];
  assert.deepEqual(wholeAsSmallAsModules(rows), { holds: 1, of: 2 });
  assert.deepEqual(wholeAsSmallAsOwn(rows), { holds: 4, of: 6 });
});
