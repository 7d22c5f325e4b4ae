// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { kRemovedSettings, kSettings } from '../generated/settings.js';
import { messageWords } from '../i18n/message_words.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';
import { withoutRemoved } from './removed_settings.js';

await messageWords.come();

test('removed settings and choices are dropped, each with a warning; the rest stays', () => {
  const { settings, warnings } = withoutRemoved({ floor: 'wavy', contrast: 0.3, objective: 'reading', colour: 'red' });
  assert.deepEqual(settings, { contrast: 0.3, colour: 'red' });
  assert.deepEqual(warnings.map((warning) => sentenceOf(warning)).sort(), [
    'The setting floor is ignored: version 0.2.0 has removed it',
    'The setting objective reading is ignored: version 0.2.0 has removed it',
  ]);
});

test('a choice that is still there stays', () => {
  assert.deepEqual(withoutRemoved({ objective: 'one-light' }), { settings: { objective: 'one-light' }, warnings: [] });
});

test('every warning says why', () => {
  for (const { key, choice } of kRemovedSettings) {
    const { warnings } = withoutRemoved({ [key]: choice ?? 1 });
    assert.equal(warnings.length, 1, key);
    assert.match(hintOf(warnings[0]), /^[A-Z].{20}/, key);
    assert.equal(key in kSettings, choice !== undefined, key);
  }
});
