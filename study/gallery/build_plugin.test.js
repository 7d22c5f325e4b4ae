// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { galleryMarkup } from './build_plugin.js';

const exhibit = (/** @type {object} */ change) => ({
  kind: 'default',
  settings: {},
  designed: 'a.webp',
  printed: 'b.webp',
  depthMm: 0.654,
  moduleMm: 1.2,
  reads: 60,
  printedReads: 40,
  tries: 72,
  ...change,
});

test('every code is a link that opens it in the app, with both pictures and what they come to', () => {
  const html = galleryMarkup(
    /** @type {any} */ ([
      { sample: 'bunny', exhibits: [exhibit({}), exhibit({ kind: 'lamp', settings: { light: '90,33,1' } })] },
    ]),
  );
  assert.match(html, /<section lang="en" class="in-en"><h2>Stanford bunny<\/h2>/);
  assert.match(html, /<section lang="de" class="in-de"><h2>Stanford-Hase<\/h2>/);
  assert.match(html, /href="\.\/\?sample=bunny&amp;engrave=1"/);
  assert.match(html, /href="\.\/\?sample=bunny&amp;light=90%2C33%2C1&amp;engrave=1"/);
  assert.match(html, /src="gallery\/a\.webp"[^>]*>.*src="gallery\/b\.webp"/);
  assert.match(html, /0\.65\smm deep; 60 of 72 tries decode the design, 40 the print/);
  assert.doesNotMatch(html, /matrix/);
});

test('a list leads to every sample, once each', () => {
  const html = galleryMarkup(
    /** @type {any} */ (['bunny', 'plate'].map((sample) => ({ sample, exhibits: [exhibit({})] }))),
  );
  assert.match(html, /<li><a href="#bunny">Stanford bunny<\/a><\/li><li><a href="#plate">Test plate<\/a><\/li>/);
  for (const sample of ['bunny', 'plate']) assert.equal(html.match(new RegExp(`id="${sample}"`, 'g'))?.length, 1);
});

test('patterns make a table, a place for each, which opens below its heading', () => {
  const html = galleryMarkup(
    /** @type {any} */ ([
      {
        sample: 'plate',
        exhibits: [exhibit({ kind: 'pattern', settings: { pattern: 'square', finderPattern: 'none' } })],
      },
    ]),
  );
  assert.match(
    html,
    /<details><summary><h3>Every pattern of modules and finders<\/h3><\/summary>\n<div class="scroll"/,
  );
  assert.equal(html.match(/<td>/g)?.length, 2 * 25);
  assert.equal(html.match(/pattern=square&amp;finderPattern=none/g)?.length, 2);
});

test('the page has a place for the gallery', () => {
  assert.match(readFileSync(new URL('../../web/gallery.html', import.meta.url), 'utf8'), /<div data-gallery><\/div>/);
});
