// SPDX-License-Identifier: GPL-3.0-or-later
// Draft of an e-mail [RFC 6068].
import { parseEmail } from './addresses.js';
import { escapeUri } from './escaping.js';
import { Findings } from './findings.js';

/** @type {import('./types.js').Content} */
export const email = {
  id: 'email',
  label: 'code.email',
  fields: [
    { id: 'address', label: 'code.email.address', kind: 'email', autocomplete: 'email' },
    { id: 'subject', label: 'code.email.subject', kind: 'text', optional: true },
    { id: 'body', label: 'code.email.body', kind: 'lines', optional: true },
  ],
  build({ address, subject, body }) {
    const findings = new Findings();
    const parsed = parseEmail(address);
    if (address.trim() === '') findings.error('address', 'code.needed');
    else if (!parsed) findings.error('address', 'code.email.wrong');
    return findings.built(() => {
      const query = Object.entries({ subject, body })
        .filter(([, value]) => value !== '')
        .map(([name, value]) => `${name}=${escapeUri(value)}`)
        .join('&');
      return `mailto:${escapeUri(parsed?.local ?? '')}@${parsed?.host}${query === '' ? '' : `?${query}`}`;
    });
  },
};
