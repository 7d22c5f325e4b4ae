// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the texts of the builders by the rules of their formats.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { text as words } from '../i18n/catalogue.js';
import { buildContent, emptyValues, kContents } from './payloads.js';

process.env.TZ = 'Europe/Berlin';

/** @param {string} id */
function contentOf(id) {
  const content = kContents.find((known) => known.id === id);
  assert.ok(content);
  return content;
}

/** @param {string} id @param {Record<string, string>} values */
const build = (id, values) => buildContent(contentOf(id), { ...emptyValues(contentOf(id)), ...values });

/**
 * Builds a payload and asserts that there are no findings.
 * @param {string} id
 * @param {Record<string, string>} values
 */
function payload(id, values) {
  const { payload: written, problems } = build(id, values);
  assert.deepEqual(problems, []);
  return written;
}

/** @param {string} id @param {Record<string, string>} values */
const findings = (id, values) =>
  build(id, values).problems.map(({ field, severity, key }) => `${severity} ${field} ${key}`);

/** Splits WIFI: and MECARD: texts into fields at unescaped semicolons. @param {string} text @param {string} start */
function parseMeCard(text, start) {
  assert.ok(text.startsWith(start) && text.endsWith(';;'), text);
  /** @type {Record<string, string>} */ const fields = {};
  let at = start.length;
  while (text[at] !== ';') {
    const colon = text.indexOf(':', at);
    let value = '';
    let end = colon + 1;
    for (; text[end] !== ';'; end += 1) {
      if (text[end] === '\\') end += 1;
      value += text[end];
    }
    fields[text.slice(at, colon)] = value;
    at = end + 1;
  }
  assert.equal(at, text.length - 1);
  return fields;
}

/** Splits a text into unfolded content lines; all but the last end with CRLF. @param {string} text */
function parseLines(text) {
  for (const line of text.split('\r\n')) {
    assert.ok(Buffer.byteLength(line) <= 75, `${Buffer.byteLength(line)} octets: ${line}`);
    assert.doesNotMatch(line, /[\r\n]/);
    assert.doesNotMatch(line, /\ufffd/);
  }
  return text
    .replaceAll('\r\n ', '')
    .split('\r\n')
    .map((line) => {
      const [, name, value] = /** @type {RegExpExecArray} */ (/^([A-Z;=-]+):(.*)$/s.exec(line));
      return { name, value };
    });
}

/** @param {string} value */
const unescapeText = (value) =>
  value.replace(/\\([\\;,nN])/g, (_, letter) => (letter.toLowerCase() === 'n' ? '\n' : letter));

/** @param {string} value */
const splitAtSemicolons = (value) => value.split(/(?<!\\)(?:\\\\)*;/);

test('every text of every builder is in the catalogue', () => {
  for (const content of kContents) {
    words(content.label);
    for (const { label, hint, options } of content.fields) {
      words(label);
      if (hint) words(hint);
      for (const option of options ?? []) words(option.label);
    }
  }
});

test('empty fields give no payload and name the missing field', () => {
  for (const content of kContents) {
    const { payload: written, problems } = buildContent(content, emptyValues(content));
    assert.equal(written, '', content.id);
    assert.ok(
      problems.some(({ severity }) => severity === 'error'),
      content.id,
    );
    for (const { field, key, values } of problems) {
      assert.ok(
        content.fields.some(({ id }) => id === field),
        `${content.id}.${field}`,
      );
      words(key, values);
    }
  }
});

test('Wi-Fi is written as the format says', () => {
  assert.equal(
    payload('wifi', { ssid: 'Café Zur Post', password: 'kaffee und kuchen' }),
    'WIFI:T:WPA;S:Café Zur Post;P:kaffee und kuchen;;',
  );
  assert.equal(
    payload('wifi', { ssid: 'open', security: 'nopass', password: 'left from before' }),
    'WIFI:T:nopass;S:open;;',
  );
  assert.equal(
    payload('wifi', { ssid: 'ours', security: 'WPA3', password: 'short', hidden: 'true' }),
    'WIFI:T:WPA;R:1;S:ours;P:short;H:true;;',
  );
});

test('Wi-Fi names and passwords survive any characters', () => {
  const special = 'a\\b;c,d"e:f\\;g\\\\';
  assert.equal(
    payload('wifi', { ssid: 'x;y', password: special }),
    'WIFI:T:WPA;S:x\\;y;P:a\\\\b\\;c\\,d\\"e\\:f\\\\\\;g\\\\\\\\;;',
  );
  assert.deepEqual(parseMeCard(payload('wifi', { ssid: special, password: special }), 'WIFI:'), {
    T: 'WPA',
    S: special,
    P: special,
  });
});

test('a Wi-Fi name of hexadecimal digits is quoted, a password never', () => {
  assert.equal(payload('wifi', { ssid: 'CAFE', password: '12345678' }), 'WIFI:T:WPA;S:"CAFE";P:12345678;;');
  assert.equal(payload('wifi', { ssid: 'CAFE!', password: '12345678' }), 'WIFI:T:WPA;S:CAFE!;P:12345678;;');
  assert.match(payload('wifi', { ssid: 'x', password: 'ab'.repeat(32) }), /P:(ab){32};/);
});

test('a Wi-Fi name has 1 to 32 bytes', () => {
  const password = 'password';
  assert.match(payload('wifi', { ssid: 'ä'.repeat(16), password }), /S:ä{16};/);
  assert.deepEqual(findings('wifi', { ssid: 'ä'.repeat(16) + 'x', password }), ['error ssid code.wifi.ssidTooLong']);
  assert.deepEqual(findings('wifi', { password }), ['error ssid code.needed']);
  assert.deepEqual(findings('wifi', { ssid: 'x ', password }), ['warning ssid code.wifi.spaces']);
});

test('a WPA password has 8 to 63 printable characters or is a key of 64 digits', () => {
  const problems = (/** @type {string} */ password) => findings('wifi', { ssid: 'x', password });
  assert.deepEqual(problems(''), ['error password code.needed']);
  assert.deepEqual(problems('1234567'), ['error password code.wifi.passwordLength']);
  assert.deepEqual(problems('12345678'), []);
  assert.deepEqual(problems('z'.repeat(63)), []);
  assert.deepEqual(problems('z'.repeat(64)), ['error password code.wifi.passwordLength']);
  assert.deepEqual(problems('0'.repeat(64)), []);
  assert.deepEqual(problems('schöner Tag'), ['error password code.wifi.ascii']);
  assert.deepEqual(problems(' 12345678'), ['warning password code.wifi.spaces']);
});

test('a WEP key has 5 or 13 characters or 10 or 26 digits, and gives a warning', () => {
  const problems = (/** @type {string} */ password) => findings('wifi', { ssid: 'x', security: 'WEP', password });
  for (const good of ['abcde', 'abcdefghijklm', '0123456789', 'ABCDEF0123456789abcdef0123']) {
    assert.deepEqual(problems(good), ['warning security code.wifi.wepIsOpen'], good);
  }
  for (const bad of ['abcd', 'abcdef', 'ghijklmnop', 'äbcde'])
    assert.deepEqual(problems(bad), ['error password code.wifi.wepKey'], bad);
});

test('a contact is a vCard 3.0 with its name in both forms', () => {
  const written = payload('contact', {
    given: 'Ada',
    family: 'Lovelace',
    phone: '+44 20 7946 0018',
    email: 'ada@example.org',
  });
  assert.equal(
    written,
    [
      'BEGIN:VCARD',
      'VERSION:3.0',
      'N:Lovelace;Ada;;;',
      'FN:Ada Lovelace',
      'TEL:+442079460018',
      'EMAIL:ada@example.org',
      'END:VCARD',
    ].join('\r\n'),
  );
});

test('every value of a vCard survives folding and escaping', () => {
  const values = {
    given: 'Zoë; Anne',
    family: 'Müller, geb. Groß',
    organisation: 'Back\\slash & Söhne',
    title: 'Chefin',
    phone: '+49 (0)30 23125-111',
    email: 'zoe@bücher.example',
    website: 'bücher.example/über?a=1,2',
    street: 'Am Markt 1; Hof',
    postcode: '01067',
    city: 'Dresden',
    country: 'Deutschland',
    note: `${'Öffnet um neun Uhr früh, schließt spät. '.repeat(5)}Ende`,
  };
  const lines = parseLines(payload('contact', values));
  const value = (/** @type {string} */ name) => lines.find((line) => line.name === name)?.value ?? '';
  assert.deepEqual(
    lines.map(({ name }) => name),
    ['BEGIN', 'VERSION', 'N', 'FN', 'ORG', 'TITLE', 'TEL', 'EMAIL', 'URL', 'ADR', 'NOTE', 'END'],
  );
  assert.deepEqual(splitAtSemicolons(value('N')).map(unescapeText), [values.family, values.given, '', '', '']);
  assert.equal(unescapeText(value('FN')), `${values.given} ${values.family}`);
  assert.equal(unescapeText(value('ORG')), values.organisation);
  assert.equal(value('TEL'), '+493023125111');
  assert.equal(value('EMAIL'), 'zoe@xn--bcher-kva.example');
  assert.equal(value('URL'), 'https://bücher.example/über?a=1,2');
  assert.deepEqual(splitAtSemicolons(value('ADR')).map(unescapeText), [
    '',
    '',
    values.street,
    'Dresden',
    '',
    '01067',
    'Deutschland',
  ]);
  assert.equal(unescapeText(value('NOTE')), values.note);
});

test('a contact without a name uses its organisation; without both it is empty', () => {
  assert.match(payload('contact', { organisation: 'ACME' }), /^N:;;;;\r\nFN:ACME\r\nORG:ACME\r$/m);
  assert.equal(payload('contact', { organisation: 'ACME', form: 'mecard' }), 'MECARD:N:ACME;;');
  assert.deepEqual(findings('contact', { phone: '+4912345', family: ' ' }), ['error given code.contact.nameless']);
});

test('a MeCard is shorter and has everything except the job title', () => {
  const values = {
    given: 'Zoë',
    family: 'Müller',
    organisation: 'A;B',
    title: 'Chefin',
    phone: '+49 30 1234',
    email: 'z@example.org',
    website: 'example.org',
    city: 'Dresden',
    postcode: '01067',
    note: 'a:b',
  };
  const card = build('contact', { ...values, form: 'mecard' });
  assert.deepEqual(
    card.problems.map(({ key }) => key),
    ['code.contact.noTitle'],
  );
  assert.deepEqual(parseMeCard(card.payload, 'MECARD:'), {
    N: 'Müller,Zoë',
    ORG: 'A;B',
    TEL: '+49301234',
    EMAIL: 'z@example.org',
    URL: 'https://example.org',
    ADR: '01067 Dresden',
    NOTE: 'a:b',
  });
  assert.ok(card.payload.length < payload('contact', values).length);
  assert.match(card.payload, /URL:https\\:\/\/example/);
});

test('a bad number, address or link is an error of its field', () => {
  const wrong = { given: 'A', phone: 'call me', email: 'a@b@c', website: 'no address' };
  assert.deepEqual(findings('contact', wrong), [
    'error phone code.phone.wrong',
    'error email code.email.wrong',
    'error website code.link.wrong',
  ]);
});

test('an e-mail has its subject and message percent-encoded', () => {
  assert.equal(payload('email', { address: 'a.b@example.org' }), 'mailto:a.b@example.org');
  const written = payload('email', { address: 'tom&jerry@example.org', subject: 'Grüße & more?', body: 'one\ntwo' });
  assert.equal(written, 'mailto:tom%26jerry@example.org?subject=Gr%C3%BC%C3%9Fe%20%26%20more%3F&body=one%0D%0Atwo');
  assert.match(written, /^[\x21-\x7e]+$/);
  const url = new URL(written);
  assert.equal(decodeURIComponent(url.pathname), 'tom&jerry@example.org');
  assert.equal(url.searchParams.get('subject'), 'Grüße & more?');
  assert.equal(url.searchParams.get('body'), 'one\r\ntwo');
});

test('an invalid e-mail address is reported', () => {
  for (const address of ['a', 'a@', '@b.org', 'a b@example.org', 'a@example', 'a@exam ple.org', 'a@.org', 'a@b..org']) {
    assert.deepEqual(findings('email', { address }), ['error address code.email.wrong'], address);
  }
  assert.deepEqual(findings('email', { address: ' ' }), ['error address code.needed']);
});

test('a text message keeps its number and every character', () => {
  assert.equal(
    payload('sms', { number: '+49 151 / 234-567', message: 'Hi: 5; ok?\nBye' }),
    'SMSTO:+49151234567:Hi: 5; ok?\nBye',
  );
  assert.equal(payload('sms', { number: '0049 151 234567' }), 'SMSTO:+49151234567');
});

test('a phone number is written as it is dialled', () => {
  assert.equal(payload('phone', { number: '+44 (0)20 7946 0018' }), 'tel:+442079460018');
  assert.deepEqual(build('phone', { number: '*100#' }).payload, 'tel:*100%23');
  assert.deepEqual(findings('phone', { number: '030 1234' }), ['warning number code.phone.local']);
  for (const number of ['12', '+1234567890123456', 'abc', '+49*5', '+', '12+34']) {
    assert.deepEqual(findings('phone', { number }), ['error number code.phone.wrong'], number);
  }
});

test('a place is in decimal degrees, with point or comma', () => {
  assert.equal(payload('place', { latitude: '52.516300', longitude: '13.3777' }), 'geo:52.5163,13.3777');
  assert.equal(payload('place', { latitude: '\u221233,9249°', longitude: '-0.0000001' }), 'geo:-33.9249,0');
  assert.equal(payload('place', { latitude: '0.000001', longitude: '180' }), 'geo:0.000001,180');
  assert.equal(
    payload('place', { latitude: '90', longitude: '-180', query: 'Café & Bar' }),
    'geo:90,-180?q=Caf%C3%A9%20%26%20Bar',
  );
});

test('a place beyond the poles or the date line is invalid', () => {
  assert.deepEqual(findings('place', { latitude: '90.1', longitude: '-180.5' }), [
    'error latitude code.place.range',
    'error longitude code.place.range',
  ]);
  assert.deepEqual(findings('place', { latitude: '52° 30′', longitude: '' }), [
    'error latitude code.place.degrees',
    'error longitude code.needed',
  ]);
});

test('an event is in UTC, in summer and in winter', () => {
  const written = payload('event', { title: 'Fest', start: '2027-07-01T18:30', end: '2027-12-24T00:15' });
  assert.equal(
    written,
    ['BEGIN:VEVENT', 'SUMMARY:Fest', 'DTSTART:20270701T163000Z', 'DTEND:20271223T231500Z', 'END:VEVENT'].join('\r\n'),
  );
});

test('a calendar has everything that iCalendar requires and is deterministic', () => {
  const values = {
    title: 'Sommerfest; mit Musik, Tanz',
    start: '2027-07-01T18:00',
    end: '2027-07-01T18:00',
    location: 'Hof\\Garten',
    description: `Bring mit:\nKuchen, ${'süß und salzig, '.repeat(8)}`.trim(),
    form: 'calendar',
  };
  const lines = parseLines(payload('event', values));
  const value = (/** @type {string} */ name) => unescapeText(lines.find((line) => line.name === name)?.value ?? '');
  assert.deepEqual(
    lines.slice(0, 4).map((line) => `${line.name}:${line.value}`),
    ['BEGIN:VCALENDAR', 'VERSION:2.0', 'PRODID:-//QRelief//EN', 'BEGIN:VEVENT'],
  );
  assert.deepEqual(
    lines.slice(-2).map((line) => line.value),
    ['VEVENT', 'VCALENDAR'],
  );
  assert.match(value('UID'), /^20270701T160000Z-[0-9a-f]{8}@qrelief$/);
  assert.match(value('DTSTAMP'), /^\d{8}T\d{6}Z$/);
  assert.equal(value('SUMMARY'), values.title);
  assert.equal(value('LOCATION'), values.location);
  assert.equal(value('DESCRIPTION'), values.description);
  assert.equal(payload('event', values), payload('event', values));
});

test('an event does not end before it starts, and has both times', () => {
  assert.deepEqual(findings('event', { title: 'x', start: '2027-01-02T10:00', end: '2027-01-02T09:59' }), [
    'error end code.event.endsFirst',
  ]);
  assert.deepEqual(findings('event', { title: 'x', start: '2027-01-02', end: '' }), [
    'error start code.event.time',
    'error end code.needed',
  ]);
});
