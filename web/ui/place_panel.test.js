// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { message } from '../engine/message.js';
import { proposedChange } from '../settings/work_settings.js';
import { changesFor } from './place_panel.js';

test('A spot that wants another lamp offers it; a wall that is too thin offers paint', () => {
  const [{ key, change }] = changesFor(message('spot-wants-another-lamp', { lamp: { term: '45,60,1' } }));
  assert.equal(key, 'page.moveLamp');
  assert.deepEqual(proposedChange(change), { light: [{ azimuthDeg: 45, elevationDeg: 60, strength: 1 }] });
  assert.deepEqual(
    changesFor(message('nothing-can-be-carved')).map(({ change: { value } }) => value),
    ['paint'],
  );
  assert.deepEqual(changesFor(message('spot-lit-unevenly-by-lamps', { count: { count: 2 } })), []);
});
