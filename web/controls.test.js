// SPDX-License-Identifier: GPL-3.0-or-later
// Fails for a control of index.html without a test. controls.spec.js also checks controls that the page makes later.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { kTestedControls } from '../e2e/support/tested_controls.js';

const kPage = readFileSync(new URL('./index.html', import.meta.url), 'utf8');

/** Returns the ids of the page's controls, and the sides that its buttons show. */
const controls = () =>
  [...kPage.matchAll(/<(?:button|input|select|textarea)\b[^>]*>/g)]
    .map(([tag]) => tag)
    .filter((tag) => !/\btype="hidden"/.test(tag))
    .flatMap((tag) => /\bid="([^"]+)"/.exec(tag)?.[1] ?? /\bdata-view="([^"]+)"/.exec(tag)?.[1] ?? []);

test('Every control in the page has a row in the tests of controls', () => {
  const ids = controls();
  assert.ok(ids.length > 50, `only ${ids.length} controls were found`);
  assert.deepEqual(
    ids.filter((id) => !kTestedControls.includes(id)),
    [],
  );
});

test('No control is tested twice', () => {
  assert.deepEqual(
    kTestedControls.filter((id, place) => kTestedControls.indexOf(id) !== place),
    [],
  );
});
