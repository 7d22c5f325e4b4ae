// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { asFarAside, aside, decoderOf, manyMarksHelp, manyMarksNeverHelp, medianTilt } from './aside.js';

const row = (
  /** @type {string} */ layout,
  /** @type {number} */ version,
  /** @type {number | null} */ tilt,
  /** @type {number} */ arc = 20,
) => ({ reader: 'jsqr 1.4.0 (npm)', version, layout, arc_deg: arc, tilt_deg: tilt });

test('a decoder is called by its name without its version', () => {
  assert.equal(decoderOf(row('projected', 2, 5)), 'jsqr');
  assert.equal(decoderOf({ reader: '@zxing/library 0.23.0 (npm)' }), '@zxing/library');
});

test('what is not read in front is less far aside than all else; where that is half of it there is no median', () => {
  const tilts = (/** @type {(number | null)[]} */ ...values) =>
    medianTilt(values.map((tilt) => row('projected', 2, tilt)));
  assert.equal(tilts(null, 0, 10), 0);
  assert.equal(tilts(null, 5, 10, 20), 7.5);
  assert.equal(tilts(null, null, 10, 20), undefined);
});

test('layouts are compared with all else the same; what neither reads tells nothing', () => {
  const rows = [
    row('projected', 2, 10),
    row('wrapped', 2, 10),
    row('projected', 3, 0),
    row('wrapped', 3, null),
    row('projected', 4, null),
    row('wrapped', 4, 5),
    row('projected', 5, null),
    row('wrapped', 5, null),
    row('projected', 6, 5),
  ];
  assert.deepEqual(asFarAside(rows, 'projected', 'wrapped'), { holds: 2, of: 3 });
});

test('more alignment patterns help where they do so at every arc', () => {
  const arc = (/** @type {number} */ at, /** @type {number | null} */ few, /** @type {number | null} */ many) => [
    row('projected', 6, few, at),
    row('projected', 7, many, at),
  ];
  assert.equal(manyMarksHelp([...arc(20, 10, 15), ...arc(100, null, 0)]), true);
  assert.equal(manyMarksHelp([...arc(20, 10, 15), ...arc(100, 0, 0)]), false);
  assert.equal(manyMarksHelp([...arc(20, 10, 15), row('projected', 6, 0, 40)]), false);
});

test('more alignment patterns never help where they do so at no arc', () => {
  const arc = (/** @type {number} */ at, /** @type {number} */ few, /** @type {number} */ many) => [
    row('projected', 6, few, at),
    row('projected', 7, many, at),
  ];
  assert.equal(manyMarksNeverHelp([...arc(20, 15, 10), ...arc(100, 5, 5)]), true);
  assert.equal(manyMarksNeverHelp([...arc(20, 15, 10), ...arc(100, 0, 5)]), false);
});

test('how far aside is said in words where it is not at all', () => {
  const arcs = (/** @type {number | null} */ wide) =>
    aside.find([row('projected', 2, 15), row('projected', 2, wide, 100)], {})[0].with;
  assert.deepEqual(arcs(5)?.wideTilt, { say: 'asideUpTo', with: { tilt: 5 } });
  assert.deepEqual(arcs(0)?.wideTilt, { say: 'asideOnlyFront' });
  assert.deepEqual(arcs(null)?.wideTilt, { say: 'asideUnread' });
  assert.deepEqual(aside.find([row('wrapped', 2, 5)], {}), []);
});
