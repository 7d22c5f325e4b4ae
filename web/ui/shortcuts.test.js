// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { kShortcuts, shortcutOf } from './shortcuts.js';

const none = { ctrlKey: false, metaKey: false, altKey: false, shiftKey: false };

test('Every shortcut operates a control of the page', () => {
  const page = readFileSync(new URL('../index.html', import.meta.url), 'utf8');
  assert.deepEqual(
    kShortcuts.map(({ control }) => control).filter((id) => !page.includes(` id="${id}"`)),
    [],
  );
});

test('Ctrl and ⌘ with Z undo, with Shift they redo, with Alt they do nothing', () => {
  assert.equal(shortcutOf({ ...none, key: 'z', ctrlKey: true })?.control, 'undo');
  assert.equal(shortcutOf({ ...none, key: 'Z', metaKey: true, shiftKey: true })?.control, 'redo');
  assert.equal(shortcutOf({ ...none, key: 'z', ctrlKey: true, altKey: true }), undefined);
  assert.equal(shortcutOf({ ...none, key: 'z' }), undefined);
});

test('Ctrl with Y redoes; ⌘ with Y is left to the browser', () => {
  assert.equal(shortcutOf({ ...none, key: 'y', ctrlKey: true })?.control, 'redo');
  assert.equal(shortcutOf({ ...none, key: 'y', metaKey: true }), undefined);
});

test('A letter counts without modifiers, a sign with any', () => {
  assert.equal(shortcutOf({ ...none, key: 'e' })?.control, 'engrave');
  assert.equal(shortcutOf({ ...none, key: 'e', ctrlKey: true }), undefined);
  assert.equal(shortcutOf({ ...none, key: 'E', shiftKey: true }), undefined);
  assert.equal(shortcutOf({ ...none, key: '?', shiftKey: true })?.control, 'help');
  assert.equal(shortcutOf({ ...none, key: '?' })?.control, 'help');
});

test('No two shortcuts are the same', () => {
  const pressed = kShortcuts.map(({ key, ctrl = false, shift = false }) => `${ctrl} ${shift} ${key}`);
  assert.equal(new Set(pressed).size, pressed.length);
});
