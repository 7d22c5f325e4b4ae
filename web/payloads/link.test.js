// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { withScheme } from './link.js';

test('a scheme is added only to a host', () => {
  assert.equal(withScheme(' example.org/x '), 'https://example.org/x');
  assert.equal(withScheme('http://example.org'), 'http://example.org');
  for (const text of ['', 'localhost', 'two words.org', 'https://']) assert.equal(withScheme(text), undefined, text);
});
