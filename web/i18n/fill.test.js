// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { text } from './catalogue.js';
import { fillTexts } from './fill.js';

test('an empty element gets its text, escaped; a filled one keeps its own', () => {
  assert.equal(
    fillTexts('<p class="a" data-text="guide.size"></p><h2 data-text="guide.light">Kept</h2>'),
    `<p class="a" data-text="guide.size">${text('guide.size')}</p><h2 data-text="guide.light">Kept</h2>`,
  );
});

test('a description gets its text', () => {
  assert.equal(
    fillTexts('<meta name="description" data-text-content="guide.description" content="" />'),
    `<meta name="description" data-text-content="guide.description" content="${text('guide.description')}" />`,
  );
});

test('a picture gets the text that stands for it', () => {
  assert.equal(
    fillTexts('<img src="a.jpg" data-text-alt="guide.paintedAlt" alt="" width="4" />'),
    `<img src="a.jpg" data-text-alt="guide.paintedAlt" alt="${text('guide.paintedAlt')}" width="4" />`,
  );
  assert.equal(fillTexts('<img src="a.jpg" alt="" />'), '<img src="a.jpg" alt="" />');
});

test('a text that does not exist fails the build', () => {
  assert.throws(() => fillTexts('<p data-text="guide.nothing"></p>'), /guide\.nothing/);
});
