// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { message } from '../engine/message.js';
import { proposedChange } from '../settings/work_settings.js';
import { changesFor } from './place_panel.js';

test('A spot that wants another lamp offers it; a wall that is too thin offers paint', () => {
  const [{ words, change }] = changesFor(message('spot-wants-another-lamp', { lamp: { term: '45,60,1' } }));
  assert.equal(words(), 'Move the lamp there');
  assert.deepEqual(proposedChange(change), { light: [{ azimuthDeg: 45, elevationDeg: 60, strength: 1 }] });
  assert.deepEqual(
    changesFor(message('nothing-can-be-carved')).map(({ change: { value } }) => value),
    ['paint'],
  );
  assert.deepEqual(changesFor(message('spot-lit-unevenly-by-lamps', { count: { count: 2 } })), []);
});

test('A fixed size for which no spot has room offers the largest size; a code of any size has none to offer', () => {
  const noSpotFor = (/** @type {import('../engine/message.js').Message} */ code) =>
    changesFor(message('no-spot-so-large', { code: { cause: code }, largest: { lengthMm: 12 } }));
  const [{ change }] = noSpotFor(message('code-with-quiet-zone', { size: { lengthMm: 24.6 } }));
  assert.deepEqual(proposedChange(change), { size: 'best' });
  assert.deepEqual(noSpotFor(message('any-code')), []);
});
