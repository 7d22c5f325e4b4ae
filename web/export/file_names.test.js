// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fileNameOf, safePart, subjectOf, symbolFileName } from './file_names.js';

test('the name has model, subject and size', () => {
  assert.equal(
    fileNameOf({
      modelFile: 'bunny.stl',
      text: 'https://en.wikipedia.org/wiki/QR_code',
      symbolMm: 31.4,
      extension: 'stl',
    }),
    'bunny-qr-en.wikipedia.org-31mm.stl',
  );
  assert.equal(
    fileNameOf({
      modelFile: 'my saddle.v2.3mf',
      text: 'Grüße aus Łódź',
      symbolMm: 25,
      addition: 'inlay',
      extension: '3mf',
    }),
    'my-saddle.v2-qr-Grusse-aus-Lodz-25mm-inlay.3mf',
  );
  assert.equal(fileNameOf({ modelFile: '模型.stl', text: '你好', extension: 'stl' }), 'model-qr.stl');
  assert.equal(
    fileNameOf({ modelFile: 'cup.stl', text: 'tel:\nRev B', content: 'text', symbolMm: 25, extension: 'stl' }),
    'cup-text-tel-Rev-B-25mm.stl',
  );
  assert.equal(symbolFileName('https://www.example.org/', 'svg'), 'qr-example.org.svg');
  assert.equal(symbolFileName('你好', 'png'), 'qr.png');
});

test('a second code like the first does not repeat its name', () => {
  const second = { text: 'https://example.org/second', symbolMm: 18, addition: 'paint', extension: '3mf' };
  const name = (/** @type {string} */ modelFile) => fileNameOf({ modelFile, ...second });
  assert.equal(name('tag-qr-example.org-18mm.3mf'), 'tag-qr-example.org-18mm-paint.3mf');
  assert.equal(name('tag-qr-example.org-18mm-paint.3mf'), 'tag-qr-example.org-18mm-paint.3mf');
  assert.equal(name('tag-qr-other.org-18mm.3mf'), 'tag-qr-other.org-18mm-qr-example.org-18mm-paint.3mf');
});

test('every kind of content has its subject, and no name has a password', () => {
  const subjects = {
    'HTTPS://WWW.EXAMPLE.ORG:80/x': 'example.org',
    'https://user:secret@example.org/': 'example.org',
    'WIFI:T:WPA;S:My\\;Net;P:secret;;': 'wifi-My-Net',
    'WIFI:P:secret;S:"CAFE";;': 'wifi-CAFE',
    'WIFI:T:WPA;P:secret;;': 'wifi',
    'MECARD:N:Lovelace,Ada;TEL:1;;': 'contact-Lovelace-Ada',
    'BEGIN:VCARD\r\nVERSION:3.0\r\nN:L;A;;;\r\nFN:Ada Lovelace\r\nEND:VCARD': 'contact-Ada-Lovelace',
    'BEGIN:VEVENT\r\nSUMMARY:Fest\\, laut\r\nEND:VEVENT': 'event-Fest-laut',
    'mailto:tom%26jerry@example.org?subject=x': 'email-tom-jerry-example.org',
    'SMSTO:+4915123:hello': 'sms-4915123',
    'tel:+442079460018': 'tel-442079460018',
    'geo:-33.9249,18.4241?q=x': 'place-33.9249_18.4241',
    'plain text': 'plain-text',
  };
  for (const [text, subject] of Object.entries(subjects)) assert.equal(subjectOf(text), subject);
});

test('the name is safe on every file system for any input', () => {
  const nasty = [
    '../../etc/passwd',
    'CON',
    'a\\b:c*d?e"f<g>h|i',
    '\u202egnp.exe',
    'x'.repeat(500),
    '...',
    '-rf',
    'a\u0000b',
    'ﬁle ½',
    ' . ',
  ];
  for (const modelFile of nasty) {
    for (const text of nasty) {
      const name = fileNameOf({ modelFile, text, symbolMm: 12.5, extension: 'stl' });
      assert.match(name, /^[A-Za-z0-9_][A-Za-z0-9._-]*\.stl$/);
      assert.doesNotMatch(name, /\.\./);
      assert.ok(name.length <= 110, name);
    }
  }
});

test('a part has no separator at its ends, even if truncated', () => {
  assert.equal(safePart('--a  b--', 10), 'a-b');
  assert.equal(safePart('abc def', 4), 'abc');
});
