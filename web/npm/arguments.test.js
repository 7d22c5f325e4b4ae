// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { runInNewContext } from 'node:vm';
import {
  bytesOf,
  checkFormat,
  checkFormats,
  checkIndex,
  checkOutputName,
  checkPoint,
  checkText,
  fileNameOf,
} from './arguments.js';
import { engrave } from './engine.js';

const kAny = /** @type {any} */ (undefined);

test('Bytes come from buffers and from views of a part of a buffer', () => {
  const { buffer } = Uint8Array.of(1, 2, 3, 4);
  assert.deepEqual(bytesOf(buffer), Uint8Array.of(1, 2, 3, 4));
  assert.deepEqual(bytesOf(new Uint8Array(buffer, 1, 2)), Uint8Array.of(2, 3));
  assert.deepEqual(bytesOf(new Uint16Array(buffer, 2)), Uint8Array.of(3, 4));
  assert.deepEqual(bytesOf(new DataView(buffer, 3)), Uint8Array.of(4));
  assert.deepEqual(bytesOf(Buffer.from('ab')), Uint8Array.of(97, 98));
  assert.deepEqual(bytesOf(runInNewContext('Uint8Array.of(5).buffer')), Uint8Array.of(5));
});

test('Bytes share the memory of what was given', () => {
  const value = Uint8Array.of(1);
  bytesOf(value.buffer)[0] = 2;
  assert.equal(value[0], 2);
});

test('Anything else is refused by its kind', () => {
  for (const [value, kind] of [
    ['part.stl', 'a string'],
    [undefined, 'undefined'],
    [[1, 2], 'an Array'],
    [new Blob(), 'a Blob'],
  ])
    assert.throws(() => bytesOf(/** @type {any} */ (value)), {
      name: 'TypeError',
      message: `The content of a file must be an ArrayBuffer, a typed array or a Buffer, not ${kind}. Read the file first.`,
    });
  assert.throws(() => fileNameOf(kAny), { name: 'TypeError', message: /must be a string, not undefined/ });
});

test('An unknown format is refused with the known ones', () => {
  checkFormats(['stl', '3mf-inlay']);
  assert.throws(() => checkFormat('svg'), {
    name: 'RangeError',
    message: 'There is no format "svg". The formats are stl, obj, ply, 3mf, 3mf-inlay.',
  });
  assert.throws(() => checkFormats('stl'), {
    name: 'TypeError',
    message: 'The formats must be an array, not a string',
  });
});

test('The extension of an output file is a format', () => {
  checkOutputName('a/part.v2.STL');
  for (const name of ['part.svg', 'part', 'part.3mf-inlay'])
    assert.throws(() => checkOutputName(name), { name: 'RangeError', message: /\.stl, \.obj, \.ply, \.3mf\.$/ });
});

test('An index is a whole number from 0, a point has three numbers', () => {
  checkIndex(7);
  for (const [index, named] of [
    [-1, '-1'],
    [0.5, '0.5'],
    ['0', 'a string'],
  ])
    assert.throws(() => checkIndex(/** @type {any} */ (index)), {
      name: 'TypeError',
      message: `An index must be a whole number from 0, not ${named}`,
    });
  checkPoint([0, -1.5, 2]);
  for (const point of [undefined, [0, 0], [0, 0, NaN], ['0', '0', '0'], { x: 0, y: 0, z: 0 }])
    assert.throws(() => checkPoint(point), {
      name: 'TypeError',
      message: /must be an array of three numbers, not an? |not undefined/,
    });
});

test('A missing text is refused', () => {
  checkText({ text: 'x' });
  for (const text of [undefined, ''])
    assert.throws(() => checkText({ text }), { kind: 'BadUsage', code: 'text-empty' });
});

// There is no Worker here: these reject before an engine starts.
test('An engraving is refused before an engine starts', async () => {
  const settings = { text: 'x' };
  await assert.rejects(engrave(new Uint8Array(9)), { kind: 'BadUsage', code: 'text-empty' });
  await assert.rejects(engrave(/** @type {any} */ ('part.stl'), { settings }), { name: 'TypeError' });
  await assert.rejects(engrave(new Uint8Array(9), { settings, formats: /** @type {any} */ (['svg']) }), {
    name: 'RangeError',
  });
});
