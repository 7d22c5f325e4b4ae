// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { decoderRates } from './decoder_rates.js';
import { sentence } from './say.js';

const row = (/** @type {string} */ decoder, /** @type {string} */ surface, /** @type {number} */ read) => ({
  decoder,
  surface,
  light: 'sky',
  tilt_deg: 0,
  pictures: 50,
  read,
  wrong: 1,
});

test('decoders come from the best to the worst, with shares of all their pictures', () => {
  const { head, body, pictures, wrong } = decoderRates([
    row('a', 'designed', 20),
    row('a', 'printed', 10),
    row('b', 'designed', 40),
    row('b', 'printed', 30),
  ]);
  assert.equal(head.length, 8);
  assert.deepEqual(
    body.map((line) => line.map((cell) => sentence('en', cell))),
    [
      ['b', '80\u00a0%', '60\u00a0%', '70\u00a0%', '–', '70\u00a0%', '–', '–'],
      ['a', '40\u00a0%', '20\u00a0%', '30\u00a0%', '–', '30\u00a0%', '–', '–'],
    ],
  );
  assert.deepEqual([pictures, wrong], [100, 4]);
});

test('without rows there is no decoder', () => {
  assert.deepEqual(decoderRates([]).body, []);
});
