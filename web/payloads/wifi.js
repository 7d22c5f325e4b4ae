// SPDX-License-Identifier: GPL-3.0-or-later
// Access to a Wi-Fi network: WIFI:T:WPA;S:name;P:password;; invented by ZXing and adopted by the WPA3 specification
// (7).
import { escapeWifi, utf8Length } from './escaping.js';
import { Findings } from './findings.js';

/** @typedef {import('./types.js').Values} Values */

const kSsidBytes = 32; // IEEE 802.11, 9.4.2.2
const kLeastPassphrase = 8,
  kMostPassphrase = 63;
const kHex = /^[0-9a-f]+$/i;
const kPrintableAscii = /^[\x20-\x7e]+$/;
const kSpaceAtAnEnd = /^\s|\s$/;

/** @param {Values} values */
const hasPassword = ({ security }) => security !== 'nopass';

/**
 * Formats a network name. A name of hexadecimal digits needs quotation marks, as it would otherwise be read as bytes. A
 * password never needs them: hexadecimal digits of a key's length are a key.
 * @param {string} ssid
 */
const writeSsid = (ssid) => (kHex.test(ssid) ? `"${ssid}"` : escapeWifi(ssid));

/** @param {Findings} findings @param {string} ssid */
function checkSsid(findings, ssid) {
  const bytes = utf8Length(ssid);
  if (bytes === 0) findings.error('ssid', 'code.needed');
  else if (bytes > kSsidBytes) findings.error('ssid', 'code.wifi.ssidTooLong', { bytes, most: kSsidBytes });
  else if (kSpaceAtAnEnd.test(ssid)) findings.warning('ssid', 'code.wifi.spaces');
}

/** @param {Findings} findings @param {string} key */
function checkWepKey(findings, key) {
  const isText = [5, 13].includes(key.length) && kPrintableAscii.test(key);
  const isHex = [10, 26].includes(key.length) && kHex.test(key);
  if (isText || isHex) findings.warning('security', 'code.wifi.wepIsOpen');
  else findings.error('password', 'code.wifi.wepKey');
}

/** @param {Findings} findings @param {Values} values */
function checkPassword(findings, { security, password }) {
  const count = password.length;
  const isPassphrase = security === 'WPA' && !(count === 64 && kHex.test(password));
  if (count === 0) findings.error('password', 'code.needed');
  else if (security === 'WEP') checkWepKey(findings, password);
  else if (isPassphrase && !kPrintableAscii.test(password)) findings.error('password', 'code.wifi.ascii');
  else if (isPassphrase && (count < kLeastPassphrase || count > kMostPassphrase)) {
    findings.error('password', 'code.wifi.passwordLength', { count, least: kLeastPassphrase, most: kMostPassphrase });
  } else if (kSpaceAtAnEnd.test(password)) findings.warning('password', 'code.wifi.spaces');
}

/** @type {import('./types.js').Content} */
export const wifi = {
  id: 'wifi',
  label: 'code.wifi',
  fields: [
    { id: 'ssid', label: 'code.wifi.ssid', kind: 'text' },
    {
      id: 'security',
      label: 'code.wifi.security',
      kind: 'choice',
      options: [
        { value: 'WPA', label: 'code.wifi.wpa' },
        { value: 'WPA3', label: 'code.wifi.wpa3' },
        { value: 'WEP', label: 'code.wifi.wep' },
        { value: 'nopass', label: 'code.wifi.open' },
      ],
    },
    {
      id: 'password',
      label: 'code.wifi.password',
      kind: 'password',
      hint: 'code.wifi.passwordHint',
      shownWhen: hasPassword,
    },
    { id: 'hidden', label: 'code.wifi.hidden', kind: 'check', optional: true },
  ],
  build(values) {
    const findings = new Findings();
    checkSsid(findings, values.ssid);
    if (hasPassword(values)) checkPassword(findings, values);
    return findings.built(() => {
      const type = values.security === 'WPA3' ? 'WPA' : values.security;
      return [
        `WIFI:T:${type};`,
        values.security === 'WPA3' ? 'R:1;' : '', // forbids the fallback to WPA2
        `S:${writeSsid(values.ssid)};`,
        hasPassword(values) ? `P:${escapeWifi(values.password)};` : '',
        values.hidden ? 'H:true;' : '',
        ';',
      ].join('');
    });
  },
};
