// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { kFinders, kPatterned, kPatterns, kPicturesFolder, kSamples, readGallery } from './exhibits.js';

const rooms = readGallery();

test('every sample has a code by default and one for a lamp, and two samples every pattern of modules and finders', () => {
  assert.deepEqual(
    rooms.map(({ sample }) => sample),
    kSamples,
  );
  const patterns = kPatterns.flatMap((pattern) => kFinders.map((finders) => `${pattern} ${finders}`));
  for (const { sample, exhibits } of rooms) {
    const shown = exhibits.map(({ kind, settings }) =>
      kind === 'pattern' ? `${settings.pattern} ${settings.finderPattern}` : kind,
    );
    const wanted = ['default', 'lamp', ...(kPatterned.includes(sample) ? patterns : [])];
    assert.deepEqual(shown.sort(), wanted.sort(), sample);
  }
});

test('every code has its two pictures, no picture lacks its code, and all together are small', () => {
  const named = rooms.flatMap(({ exhibits }) => exhibits.flatMap(({ designed, printed }) => [designed, printed]));
  const files = readdirSync(kPicturesFolder).filter((file) => !file.endsWith('.json'));
  assert.deepEqual([...named].sort(), files.sort());
  const pictures = files.map((file) => readFileSync(`${kPicturesFolder}/${file}`));
  pictures.forEach((bytes, at) => assert.equal(bytes.toString('latin1', 8, 12), 'WEBP', files[at]));
  const total = pictures.reduce((sum, { length }) => sum + length, 0);
  assert.ok(total < 1_500_000, `${total} bytes`);
});
