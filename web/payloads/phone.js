// SPDX-License-Identifier: GPL-3.0-or-later
// Telephone number to call [RFC 3966].
import { parsePhone } from './addresses.js';
import { Findings } from './findings.js';

/**
 * Checks a required number.
 * @param {Findings} findings @param {string} field @param {string} number
 * @returns {string}  as it is dialled
 */
export function checkPhone(findings, field, number) {
  const parsed = parsePhone(number);
  if (number.trim() === '') findings.error(field, 'code.needed');
  else if (!parsed) findings.error(field, 'code.phone.wrong');
  else if (!parsed.international) findings.warning(field, 'code.phone.local');
  return parsed?.dialled ?? '';
}

/** @type {import('./types.js').Content} */
export const phone = {
  id: 'phone',
  label: 'code.phone',
  fields: [{ id: 'number', label: 'code.phone.number', kind: 'tel', autocomplete: 'tel' }],
  build({ number }) {
    const findings = new Findings();
    const dialled = checkPhone(findings, 'number', number);
    return findings.built(() => `tel:${dialled.replaceAll('#', '%23')}`);
  },
};
