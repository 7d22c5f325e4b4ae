// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { text } from './catalogue.js';
import { formatBox, formatMm, formatPercent, formatSeconds } from './format.js';
import { sentenceOf } from './messages.js';
import { withUnitsKept } from './units.js';

test('A number, its unit and a short word before it stay on one line; other words may break', () => {
  const broken = '{a} mm, 100 % of 3 m by 2.5 mm; of 5 modules, 2 good, 1 mmm, 8 × 8 mm; auf 4°, auf {b}°, unter 4°';
  const kept = '{a}_mm, 100_% of_3_m by_2.5_mm; of 5 modules, 2 good, 1 mmm, 8 × 8_mm; auf_4°, auf_{b}°, unter 4°';
  assert.equal(withUnitsKept(broken), kept.replaceAll('_', '\u00a0'));
});

test('Sentences keep the units of their values', () => {
  const told = { code: 'v', values: { a: { lengthMm: 0.4 }, b: { fraction: 1 }, c: { number: 2 } } };
  const words = { v: { says: '{a}, {b}, {c} MB' } };
  assert.equal(sentenceOf(told, words), '0.4\u00a0mm, 100\u00a0%, 2\u00a0MB');
});

test('Texts and formatted values keep their units', () => {
  assert.equal(text('view.millimetres', { mm: '4' }), '4\u00a0mm');
  assert.deepEqual(
    [formatMm(0.4), formatBox([1, 20]), formatSeconds(1500), formatPercent(0.333)],
    ['0.40\u00a0mm', '1.00 × 20.0\u00a0mm', '1.5\u00a0s', '33\u00a0%'],
  );
});
