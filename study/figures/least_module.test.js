// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { asSmall, leastOf } from './least_module.js';

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
