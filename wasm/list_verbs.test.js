// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { macroOf } from './list_verbs.js';

test('A macro names the class and the method of each row', () => {
  assert.equal(
    macroOf('VERBS', 'Engine', { pick: {}, draw: { of: 'InspectedEngine' } }),
    '#define VERBS(verb) \\\n  verb(Engine, pick) \\\n  verb(InspectedEngine, draw)',
  );
});
