// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { History } from './history.js';

/** @typedef {{ text: string, bytes?: Uint8Array }} State */

function makeHistory() {
  const clock = { ms: 0 };
  /** @type {History<State>} */
  const history = new History({
    same: (a, b) => a.text === b.text,
    bytesOf: ({ bytes }) => bytes,
    now: () => clock.ms,
  });
  return { history, clock };
}

test('Changes are undone and redone in order', () => {
  const { history } = makeHistory();
  for (const text of ['a', 'b', 'c']) history.record({ text });
  assert.equal(history.go(-1)?.text, 'b');
  assert.equal(history.go(-1)?.text, 'a');
  assert.equal(history.go(-1), undefined);
  assert.equal(history.go(1)?.text, 'b');
  assert.equal(history.go(1)?.text, 'c');
  assert.equal(history.go(1), undefined);
});

test('An amended state is undone as one with what it amends', () => {
  const { history } = makeHistory();
  history.amend({ text: 'before the first' });
  assert.equal(history.reaches(-1), false);
  for (const text of ['a', 'b']) history.record({ text });
  history.amend({ text: 'b, proposed' });
  history.record({ text: 'c' });
  assert.equal(history.go(-1)?.text, 'b, proposed');
  assert.equal(history.go(-1)?.text, 'a');
  assert.equal(history.reaches(-1), false);
});

test('The first state cannot be undone', () => {
  const { history } = makeHistory();
  assert.deepEqual([history.reaches(-1), history.reaches(1)], [false, false]);
  history.record({ text: 'a' });
  assert.deepEqual([history.reaches(-1), history.reaches(1)], [false, false]);
});

test('A state equal to the last is not a change', () => {
  const { history } = makeHistory();
  history.record({ text: 'a' });
  history.record({ text: 'a' });
  assert.equal(history.reaches(-1), false);
});

test('A change after an undo clears the redo list', () => {
  const { history } = makeHistory();
  for (const text of ['a', 'b', 'c']) history.record({ text });
  history.go(-1);
  history.record({ text: 'd' });
  assert.equal(history.reaches(1), false);
  assert.equal(history.go(-1)?.text, 'b');
});

test('Only quick edits of the same field are undone together', () => {
  const { history, clock } = makeHistory();
  history.record({ text: '' });
  for (const text of ['h', 'he', 'hel']) {
    history.record({ text }, 'text');
    clock.ms += 900;
  }
  clock.ms += 101;
  history.record({ text: 'hello' }, 'text');
  history.record({ text: 'hello, 20 mm' }, 'size');
  assert.equal(history.go(-1)?.text, 'hello');
  assert.equal(history.go(-1)?.text, 'hel');
  assert.equal(history.go(-1)?.text, '');
});

test('The first edit of a field and an edit after an undo are never merged', () => {
  const { history } = makeHistory();
  history.record({ text: 'a' }, 'text');
  history.record({ text: 'ab' }, 'text');
  assert.equal(history.go(-1)?.text, 'a');
  history.record({ text: 'ac' }, 'text');
  assert.equal(history.go(-1)?.text, 'a');
});

test('The oldest of very many changes are dropped', () => {
  const { history } = makeHistory();
  for (let i = 0; i < 500; i += 1) history.record({ text: String(i) });
  let steps = 0;
  while (history.go(-1)) steps += 1;
  assert.equal(steps, 199);
});

test('At most 512 MiB of models are kept besides the open one', () => {
  const { history } = makeHistory();
  const large = () => /** @type {any} */ ({ byteLength: 200 * 1024 * 1024 });
  for (const text of ['a', 'b', 'c', 'd']) history.record({ text, bytes: large() });
  assert.equal(history.go(-1)?.text, 'c');
  assert.equal(history.go(-1)?.text, 'b');
  assert.equal(history.go(-1), undefined);
});

test('A model shared by many states counts once', () => {
  const { history } = makeHistory();
  const bytes = /** @type {any} */ ({ byteLength: 300 * 1024 * 1024 });
  for (const text of ['a', 'b', 'c', 'd']) history.record({ text, bytes });
  history.record({ text: 'e', bytes: new Uint8Array(1) });
  let steps = 0;
  while (history.go(-1)) steps += 1;
  assert.equal(steps, 4);
});
