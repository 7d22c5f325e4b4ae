// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  findersApart,
  findersLowerDepth,
  looseAreShallowest,
  patternsAreShallower,
  squareFromDiamond,
  thickPlusIsDeepest,
  thinPlusIsShallowest,
} from './pattern_depths.js';

const depths = (/** @type {Record<string, number>} */ byPattern) =>
  Object.entries(byPattern).map(([modules, mm]) => ({ modules, finders: 'as-modules', depth_mm: mm }));
const kPaper = { none: 0.8, square: 0.4, 'thin-plus': 0.3, diamond: 0.5, 'thick-plus': 0.6 };

test('the paper’s order of patterns is recognised, and each statement fails alone', () => {
  const judge = (/** @type {Record<string, number>} */ changed) => {
    const rows = depths({ ...kPaper, ...changed });
    return [looseAreShallowest(rows), thinPlusIsShallowest(rows), thickPlusIsDeepest(rows)];
  };
  assert.deepEqual(judge({}), [true, true, true]);
  assert.deepEqual(judge({ square: 0.55 }), [false, true, true]);
  assert.deepEqual(judge({ square: 0.2 }), [true, false, true]);
  assert.deepEqual(judge({ diamond: 0.7 }), [true, true, false]);
  assert.equal(looseAreShallowest(depths({ none: 1, square: 2 })), undefined);
  assert.equal(looseAreShallowest(depths(kPaper), 'none'), undefined);
});

test('each pattern must be shallower than whole modules, and two patterns can be near each other', () => {
  assert.equal(patternsAreShallower(depths(kPaper)), true);
  assert.equal(patternsAreShallower(depths({ ...kPaper, 'thick-plus': 0.8 })), false);
  assert.ok(Math.abs((squareFromDiamond(depths(kPaper)) ?? NaN) - 0.1) < 1e-12);
  assert.equal(squareFromDiamond(depths({ square: 0.4 })), undefined);
});

test('finder patterns are compared with whole finders of the same modules and model', () => {
  const row = (/** @type {string} */ model, /** @type {string} */ finders, /** @type {number} */ mm) => ({
    model,
    modules: 'square',
    finders,
    depth_mm: mm,
  });
  const others = [row('b', 'diamond', 0.1), row('a', 'as-modules', 0.1)];
  const rows = [row('a', 'none', 0.5), row('a', 'diamond', 0.4), row('a', 'thick-plus', 0.5), ...others];
  assert.deepEqual(findersLowerDepth(rows), { holds: 1, of: 2 });
  assert.ok(Math.abs(findersApart(rows) - 0.1) < 1e-12);
});
