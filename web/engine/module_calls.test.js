// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { callsOf } from './module_calls.js';
import { kBatchVerbs, kFactVerbs, kHostVerbs, kInnerVerbs, kPageVerbs } from './verbs.js';

/** Calls the module's only verb. @param {any} answer @param {any[]} given @param {string} [part] */
function called(answer, given, part) {
  /** @type {any[]} */ let received = [];
  const object = {
    verb: (/** @type {any[]} */ ...args) => {
      received = args;
      return answer;
    },
  };
  /** @type {{ verb: import('./verbs.js').Verb<(...given: any[]) => any> }} */ const rows = { verb: { part } };
  const value = callsOf(object, rows).verb(...given);
  return { received, value };
}

test('Objects and lists travel as JSON, numbers, texts and bytes as they are', () => {
  const bytes = Uint8Array.of(1, 2);
  const metrics = Float32Array.of(3);
  const { received } = called(true, [{ a: 1 }, ['b'], 4, 'c', false, bytes, metrics]);
  assert.deepEqual(received, ['{"a":1}', '["b"]', 4, 'c', false, bytes, metrics]);
});

test('A text is a JSON answer, of which the caller may get a part; every other answer is the value', () => {
  assert.deepEqual(called('{"ok":true,"symbol":{"size":21}}', [], 'symbol').value, { size: 21 });
  assert.deepEqual(called('{"problems":[]}', []).value, { problems: [] });
  assert.equal(called(7, []).value, 7);
  const picture = { width: 1, height: 1, pixels: Uint8Array.of(9) };
  assert.equal(called(picture, []).value, picture);
});

test('A failure is thrown', () => {
  const error = { kind: 'BadUsage', code: 'no-model', values: {} };
  assert.throws(() => called(JSON.stringify({ ok: false, error }), []), { kind: 'BadUsage', code: 'no-model' });
});

test('No verb stands in two tables', () => {
  const names = [kPageVerbs, kBatchVerbs, kFactVerbs].flatMap(Object.keys).concat(kHostVerbs);
  assert.deepEqual(
    names.filter((name, at) => names.indexOf(name) !== at),
    [],
  );
  assert.deepEqual(
    Object.keys(kInnerVerbs).filter((name) => name in kPageVerbs),
    [],
  );
});
