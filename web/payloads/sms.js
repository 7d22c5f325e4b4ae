// SPDX-License-Identifier: GPL-3.0-or-later
// Draft of a text message: SMSTO:number:message, which all phones recognise. The message is everything after the second
// colon, without escaping.
import { Findings } from './findings.js';
import { checkPhone } from './phone.js';

/** @type {import('./types.js').Content} */
export const sms = {
  id: 'sms',
  label: 'code.sms',
  fields: [
    { id: 'number', label: 'code.phone.number', kind: 'tel', autocomplete: 'tel' },
    { id: 'message', label: 'code.sms.message', kind: 'lines', optional: true },
  ],
  build({ number, message }) {
    const findings = new Findings();
    const dialled = checkPhone(findings, 'number', number);
    return findings.built(() => `SMSTO:${dialled}${message === '' ? '' : `:${message}`}`);
  },
};
