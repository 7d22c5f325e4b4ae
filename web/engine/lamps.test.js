// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { kSettings } from '../generated/settings.js';
import { areLamps, lampsFrom, lampsText } from './lamps.js';

const kLamps = [
  { azimuthDeg: 135, elevationDeg: 20, strength: 19 },
  { azimuthDeg: -90, elevationDeg: 22.5 },
];

test('lamps are read in the command’s format and written so that they can be read again', () => {
  assert.deepEqual(lampsFrom('135,20,19 -90,22.5'), kLamps);
  assert.equal(lampsText(kLamps), '135,20,19 -90,22.5');
  assert.deepEqual(lampsFrom(' 135, 20 , 19\t'), [kLamps[0]]);
  assert.deepEqual(lampsFrom(' '), []);
  assert.equal(lampsText([]), '');
});

test('an invalid lamp is undefined', () => {
  for (const text of [
    'top',
    '135',
    '135,20,19,1',
    '135,20,',
    ',20',
    '135,,19',
    '135;20;19',
    '0x10,20',
    '1e2,20',
    '135,20,19 left',
    'NaN,20',
    '.,20',
  ]) {
    assert.equal(lampsFrom(text), undefined, text);
  }
});

test('lamps of a file have numeric parts only', () => {
  assert.ok(areLamps(kLamps) && areLamps([]));
  const [lamp] = kLamps;
  for (const value of [
    null,
    '135,20,19',
    {},
    [null],
    [[135, 20]],
    [{}],
    [{ azimuthDeg: 135 }],
    [{ ...lamp, strength: '19' }],
    [{ ...lamp, colour: 1 }],
    [{ ...lamp, elevationDeg: null }],
  ]) {
    assert.equal(areLamps(value), false, JSON.stringify(value));
  }
});

test('the parts are the core’s', () => {
  assert.deepEqual(Object.keys(kSettings.light.parts ?? {}).sort(), Object.keys(kLamps[0]).sort());
});
