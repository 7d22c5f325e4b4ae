// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the tests that docs/comparison.md names for each of our features: each must exist, by file and name.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const read = (/** @type {string} */ path) => readFileSync(new URL(`../${path}`, import.meta.url), 'utf8');

const [table, list] = read('docs/comparison.md').split('## Held by');
const held = [...list.matchAll(/^- \[(\d+)\] `([^`]+)` “([^”]+)”$/gm)].map(([, feature, file, name]) => ({
  feature,
  file,
  name,
}));

test('every feature names its tests, and every named test belongs to a feature', () => {
  const features = [...table.matchAll(/\[(\d+)\]/g)].map(([, number]) => number);
  assert.ok(features.length >= 15);
  assert.deepEqual(new Set(held.map(({ feature }) => feature)), new Set(features));
});

test('the named tests exist', () => {
  assert.equal(held.length, list.split('\n').filter((line) => line.startsWith('- ')).length);
  for (const { file, name } of held) assert.ok(read(file).includes(name), `${file}: ${name}`);
});
