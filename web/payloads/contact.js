// SPDX-License-Identifier: GPL-3.0-or-later
// Address book entry: vCard 3.0 [RFC 2426], or the shorter MeCard of NTT Docomo.
import { parseEmail, parsePhone } from './addresses.js';
import { contentLines, escapeMeCard, escapeText } from './escaping.js';
import { Findings } from './findings.js';
import { withScheme } from './link.js';

/** @typedef {import('./types.js').Values} Values */
/** @typedef {Values & { phone: string, email: string, website: string }} Entry  checked and normalised */

/** @param {Findings} findings @param {Values} values @returns {Entry} */
function checkEntry(findings, values) {
  const trimmed = Object.fromEntries(Object.entries(values).map(([id, value]) => [id, value.trim()]));
  if (trimmed.given === '' && trimmed.family === '' && trimmed.organisation === '')
    findings.error('given', 'code.contact.nameless');
  const phone = parsePhone(trimmed.phone);
  if (trimmed.phone !== '' && !phone) findings.error('phone', 'code.phone.wrong');
  else if (phone && !phone.international) findings.warning('phone', 'code.phone.local');
  const email = parseEmail(trimmed.email);
  if (trimmed.email !== '' && !email) findings.error('email', 'code.email.wrong');
  const website = trimmed.website === '' ? '' : withScheme(trimmed.website);
  if (website === undefined) findings.error('website', 'code.link.wrong');
  if (trimmed.form === 'mecard' && trimmed.title !== '') findings.warning('title', 'code.contact.noTitle');
  return {
    ...trimmed,
    phone: phone?.dialled ?? '',
    email: email ? `${email.local}@${email.host}` : '',
    website: website ?? '',
  };
}

/** Returns a line, or nothing if the value is ''. @param {string} start @param {string} value  already escaped */
const line = (start, value) => (value === '' ? [] : [`${start}${value}`]);

/** @param {Entry} entry */
function writeVCard(entry) {
  const { given, family, organisation, title, phone, email, website, street, postcode, city, country, note } = entry;
  const fullName = [given, family].filter(Boolean).join(' ') || organisation;
  const address = [street, city, postcode, country].some(Boolean)
    ? ['', '', street, city, '', postcode, country].map(escapeText).join(';')
    : '';
  return contentLines([
    'BEGIN:VCARD',
    'VERSION:3.0',
    `N:${[family, given, '', '', ''].map(escapeText).join(';')}`,
    `FN:${escapeText(fullName)}`,
    ...line('ORG:', escapeText(organisation)),
    ...line('TITLE:', escapeText(title)),
    ...line('TEL:', phone),
    ...line('EMAIL:', escapeText(email)),
    ...line('URL:', website),
    ...line('ADR:', address),
    ...line('NOTE:', escapeText(note)),
    'END:VCARD',
  ]);
}

/** @param {Entry} entry */
function writeMeCard(entry) {
  const { given, family, organisation, phone, email, website, street, postcode, city, country, note } = entry;
  const name = [family, given].filter(Boolean).map(escapeMeCard).join(',') || escapeMeCard(organisation);
  const town = [postcode, city].filter(Boolean).join(' ');
  const address = [street, town, country].filter(Boolean).map(escapeMeCard).join(',');
  const parts = [
    ...line('N:', name),
    ...line('ORG:', given || family ? escapeMeCard(organisation) : ''),
    ...line('TEL:', phone),
    ...line('EMAIL:', escapeMeCard(email)),
    ...line('URL:', escapeMeCard(website)),
    ...line('ADR:', address),
    ...line('NOTE:', escapeMeCard(note)),
  ];
  return `MECARD:${parts.map((part) => `${part};`).join('')};`;
}

/** @type {import('./types.js').Content} */
export const contact = {
  id: 'contact',
  label: 'code.contact',
  fields: [
    { id: 'given', label: 'code.contact.given', kind: 'text', autocomplete: 'given-name', half: true },
    {
      id: 'family',
      label: 'code.contact.family',
      kind: 'text',
      autocomplete: 'family-name',
      optional: true,
      half: true,
    },
    { id: 'phone', label: 'code.contact.phone', kind: 'tel', autocomplete: 'tel', optional: true },
    { id: 'email', label: 'code.email.address', kind: 'email', autocomplete: 'email', optional: true },
    { id: 'website', label: 'code.contact.website', kind: 'url', autocomplete: 'url', optional: true },
    {
      id: 'organisation',
      label: 'code.contact.organisation',
      kind: 'text',
      autocomplete: 'organization',
      optional: true,
      half: true,
    },
    {
      id: 'title',
      label: 'code.contact.title',
      kind: 'text',
      autocomplete: 'organization-title',
      optional: true,
      half: true,
    },
    { id: 'street', label: 'code.contact.street', kind: 'text', autocomplete: 'street-address', optional: true },
    {
      id: 'postcode',
      label: 'code.contact.postcode',
      kind: 'text',
      autocomplete: 'postal-code',
      optional: true,
      half: true,
    },
    {
      id: 'city',
      label: 'code.contact.city',
      kind: 'text',
      autocomplete: 'address-level2',
      optional: true,
      half: true,
    },
    { id: 'country', label: 'code.contact.country', kind: 'text', autocomplete: 'country-name', optional: true },
    { id: 'note', label: 'code.contact.note', kind: 'text', optional: true },
    {
      id: 'form',
      label: 'code.form',
      kind: 'choice',
      options: [
        { value: 'vcard', label: 'code.contact.vcard' },
        { value: 'mecard', label: 'code.contact.mecard' },
      ],
    },
  ],
  build(values) {
    const findings = new Findings();
    const entry = checkEntry(findings, values);
    return findings.built(() => (values.form === 'mecard' ? writeMeCard(entry) : writeVCard(entry)));
  },
};
