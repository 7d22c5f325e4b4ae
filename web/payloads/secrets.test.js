// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { wifi } from './wifi.js';
import { holdsSecret, withoutSecrets } from './secrets.js';

test('no part of a Wi-Fi password is left, whatever its characters', () => {
  for (const password of ['password', 'pass;word', 'a\\b;P:c"d', ';;;;;;;;', 'ends in \\\\', ':P:;P:;x']) {
    const { payload } = wifi.build({ ssid: 'S;P:x', security: 'WPA', password, hidden: 'true' });
    assert.equal(withoutSecrets(payload), 'WIFI:T:WPA;S:S\\;P\\:x;P:;H:true;;', password);
    assert.ok(holdsSecret(payload));
  }
});

test('an unterminated password is removed too', () => {
  assert.equal(withoutSecrets('wifi:S:x;P:secret'), 'wifi:S:x;P:');
  assert.equal(withoutSecrets('WIFI:P:secret\\'), 'WIFI:P:');
});

test('every other text stays unchanged', () => {
  for (const text of ['https://example.org/;P:x;', 'MECARD:N:a;P:b;;', 'P:secret;', 'WIFI:T:nopass;S:P;;', '']) {
    assert.equal(withoutSecrets(text), text);
    assert.ok(!holdsSecret(text));
  }
});
