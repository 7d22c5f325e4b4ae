// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { adviseText, shorterForms, withScheme, withoutTracking } from './link.js';

/** @param {string} text */
const keys = (text) => adviseText(text).map(({ key }) => key);

/** @param {string} text */
const fixed = (text) => adviseText(text).map((advice) => advice.fixed);

test('a good link and plain text need no advice', () => {
  for (const text of [
    'https://example.org/a?b=c#d',
    'http://192.168.0.1:8080/',
    'Hello world',
    '3.14',
    'a.b c.d',
    '',
    'bunny.stl',
    'name@example.org',
    'WIFI:T:nopass;S:x;;',
    'z.B.',
    'e.g. this',
    'https://[2001:db8::1]/',
    'http://localhost:3000/',
  ]) {
    assert.deepEqual(keys(text), [], text);
  }
});

test('an address without its scheme gets https', () => {
  for (const text of [
    'example.org',
    'www.example.org/a b'.replace(' ', '%20'),
    'EXAMPLE.ORG:8080?x',
    'bücher.example',
    'a.co/bunny.stl',
  ]) {
    assert.deepEqual(keys(text), ['code.link.noScheme'], text);
    assert.deepEqual(fixed(text), [`https://${text}`]);
  }
  assert.deepEqual(fixed(' example.org '), ['https://example.org']);
});

test('spaces within and around a link are found', () => {
  assert.deepEqual(fixed('https://example.org/a b  c'), ['https://example.org/a%20b%20c']);
  assert.deepEqual(fixed('https://example.org/a\n'), ['https://example.org/a']);
  assert.deepEqual(keys('https://example.org/a b'), ['code.link.spaces']);
});

test('a text that only starts like a link is reported', () => {
  for (const text of ['https://', 'https://x', 'http://exa%mple.org', 'https://example.org:99999/']) {
    assert.deepEqual(keys(text), ['code.link.wrong'], text);
  }
});

test('a name in other letters can be written in ASCII, and the rest of the link stays', () => {
  const [advice] = adviseText('https://Bücher.example:8080/Über?x=ü');
  assert.equal(advice.key, 'code.link.idn');
  assert.equal(advice.fixed, 'https://xn--bcher-kva.example:8080/Über?x=ü');
});

test('only tracking parameters are removed from the query', () => {
  assert.equal(
    withoutTracking('https://e.org/?utm_source=a&b=%20&fbclid=1&c#d?utm_x=1'),
    'https://e.org/?b=%20&c#d?utm_x=1',
  );
  assert.equal(withoutTracking('https://e.org/p?gclid=1'), 'https://e.org/p');
  assert.equal(withoutTracking('https://e.org/p?q=utm_source'), 'https://e.org/p?q=utm_source');
  assert.deepEqual(keys(`https://example.org/page?utm_campaign=${'x'.repeat(50)}`), ['code.link.tracking']);
  assert.equal(adviseText(`https://example.org/page?utm_campaign=${'x'.repeat(50)}`)[0].severity, 'warning');
  assert.equal(adviseText('https://e.org/?gclid=1')[0].severity, 'note');
});

test('scheme and host may be upper case, the rest must stay', () => {
  assert.deepEqual(shorterForms('https://en.wikipedia.org/wiki/QR_code'), [
    { text: 'HTTPS://EN.WIKIPEDIA.ORG/wiki/QR_code', key: 'code.shorter.capitals', same: true },
  ]);
  assert.equal(shorterForms('https://example.org/')[0].text, 'HTTPS://EXAMPLE.ORG');
  assert.equal(shorterForms('https://example.org/?a=b')[0].text, 'HTTPS://EXAMPLE.ORG/?a=b');
  assert.equal(new URL(shorterForms('https://example.org/Path?Q=q#F')[0].text).href, 'https://example.org/Path?Q=q#F');
});

test('removing www. or a text fragment is offered as another address', () => {
  const forms = shorterForms('https://www.example.org/a#:~:text=some%20words');
  assert.deepEqual(
    forms.map(({ key, same }) => [key, same]),
    [
      ['code.shorter.capitals', true],
      ['code.shorter.www', false],
      ['code.shorter.highlight', false],
    ],
  );
  assert.equal(forms[1].text, 'HTTPS://EXAMPLE.ORG/a#:~:text=some%20words');
  assert.equal(forms[2].text, 'https://www.example.org/a');
  assert.deepEqual(
    shorterForms('https://www.org/').map(({ key }) => key),
    ['code.shorter.capitals'],
  );
});

test('nothing is suggested for a text that is not a plain link', () => {
  for (const text of [
    'hello',
    'https://bücher.example/',
    'https://user@example.org/',
    'HTTPS://EXAMPLE.ORG',
    'mailto:a@example.org',
  ]) {
    assert.deepEqual(shorterForms(text), [], text);
  }
});

test('a scheme is added only to a host', () => {
  assert.equal(withScheme(' example.org/x '), 'https://example.org/x');
  assert.equal(withScheme('http://example.org'), 'http://example.org');
  for (const text of ['', 'localhost', 'two words.org', 'https://']) assert.equal(withScheme(text), undefined, text);
});
