// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { GestureReader } from './gestures.js';

/** Returns the listener's calls for a series of events. @param {(reader: GestureReader) => void} play */
function heard(play) {
  /** @type {any[]} */ const calls = [];
  const tell =
    (/** @type {string} */ name) =>
    (/** @type {unknown[]} */ ...values) =>
      calls.push([name, ...values]);
  play(new GestureReader({ onOrbit: tell('orbit'), onPan: tell('pan'), onZoom: tell('zoom'), onClick: tell('click') }));
  return calls;
}

/** @param {number} x @param {number} y @param {object} [more] */
const at = (x, y, more = {}) => ({
  clientX: x,
  clientY: y,
  offsetX: x,
  offsetY: y,
  pointerId: 1,
  pointerType: 'mouse',
  button: 0,
  buttons: 1,
  shiftKey: false,
  altKey: false,
  ...more,
});

test('A press that hardly moves is a click and turns nothing', () => {
  assert.deepEqual(
    heard((reader) => {
      reader.pointer('pointerdown', at(10, 10));
      reader.pointer('pointermove', at(12, 11));
      reader.pointer('pointerup', at(12, 11));
    }),
    [['click', 12, 11, false]],
  );
});

test('A click tells whether Alt was held', () => {
  const calls = heard((reader) => {
    reader.pointer('pointerdown', at(10, 10));
    reader.pointer('pointerup', at(10, 10, { altKey: true }));
  });
  assert.deepEqual(calls, [['click', 10, 10, true]]);
});

test('A drag turns by its whole movement, including the part before it was recognised', () => {
  assert.deepEqual(
    heard((reader) => {
      reader.pointer('pointerdown', at(10, 10));
      reader.pointer('pointermove', at(13, 10));
      reader.pointer('pointermove', at(18, 11));
      reader.pointer('pointerup', at(18, 11));
    }),
    [['orbit', 8, 1]],
  );
});

test('A drag that returns to its start is not a click', () => {
  const calls = heard((reader) => {
    reader.pointer('pointerdown', at(10, 10));
    for (const x of [20, 30, 20, 10]) reader.pointer('pointermove', at(x, 10));
    reader.pointer('pointerup', at(10, 10));
  });
  assert.ok(calls.every(([name]) => name === 'orbit'));
});

test('The right button, the middle one and Shift pan, and never click', () => {
  for (const more of [{ button: 2, buttons: 2 }, { button: 1, buttons: 4 }, { shiftKey: true }]) {
    assert.deepEqual(
      heard((reader) => {
        reader.pointer('pointerdown', at(0, 0, more));
        reader.pointer('pointermove', at(20, 5, more));
        reader.pointer('pointerup', at(20, 5, { ...more, buttons: 0 }));
        reader.pointer('pointerdown', at(0, 0, more));
        reader.pointer('pointerup', at(0, 0, { ...more, buttons: 0 }));
      }),
      [['pan', 20, 5]],
    );
  }
});

test('Two fingers zoom around their middle by the ratio of their distances, and lifting them is not a click', () => {
  const finger = (/** @type {number} */ id) => ({ pointerId: id, pointerType: 'touch' });
  assert.deepEqual(
    heard((reader) => {
      reader.pointer('pointerdown', at(100, 50, finger(1)));
      reader.pointer('pointerdown', at(200, 50, finger(2)));
      reader.pointer('pointermove', at(300, 50, finger(2)));
      reader.pointer('pointerup', at(300, 50, finger(2)));
      reader.pointer('pointerup', at(100, 50, finger(1)));
    }),
    [
      ['pan', 50, 0],
      ['zoom', 2, 200, 50],
    ],
  );
});

test('A cancelled pointer clicks nothing', () => {
  assert.deepEqual(
    heard((reader) => {
      reader.pointer('pointerdown', at(1, 1));
      reader.pointer('pointercancel', at(1, 1));
    }),
    [],
  );
});

test('Turning the wheel up zooms in, by lines or pixels', () => {
  const wheel = { ctrlKey: false, offsetX: 3, offsetY: 4 };
  const [[, byPixels], [, byLines]] = heard((reader) => {
    reader.wheel({ ...wheel, deltaY: -48, deltaMode: 0 });
    reader.wheel({ ...wheel, deltaY: -3, deltaMode: 1 });
  });
  assert.ok(byPixels > 1);
  assert.equal(byPixels, byLines);
});
