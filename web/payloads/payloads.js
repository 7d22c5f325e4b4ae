// SPDX-License-Identifier: GPL-3.0-or-later
// All kinds of content that have fields, in the order in which the page offers them. Links and plain text have none.
import { contact } from './contact.js';
import { email } from './email.js';
import { event } from './event.js';
import { phone } from './phone.js';
import { place } from './place.js';
import { sms } from './sms.js';
import { wifi } from './wifi.js';

/** @typedef {import('./types.js').Content} Content */
/** @typedef {import('./types.js').Values} Values */

/** @type {readonly Content[]} */
export const kContents = [wifi, contact, email, sms, phone, place, event];

/** Returns the initial values of the fields. @param {Content} content @returns {Values} */
export const emptyValues = ({ fields }) =>
  Object.fromEntries(fields.map(({ id, options }) => [id, options?.[0].value ?? '']));

/**
 * Builds the text from the visible fields; hidden fields count as empty.
 * @param {Content} content
 * @param {Values} values
 */
export function buildContent(content, values) {
  const visible = content.fields.filter(({ shownWhen }) => shownWhen?.(values) ?? true).map(({ id }) => id);
  return content.build(
    Object.fromEntries(content.fields.map(({ id }) => [id, visible.includes(id) ? (values[id] ?? '') : ''])),
  );
}
