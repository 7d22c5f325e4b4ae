// SPDX-License-Identifier: GPL-3.0-or-later
// What a kind of content is made of: fields to fill in, and the text that a code for them holds. No code.

/** @typedef {import('../i18n/catalogue.js').Key} Key */

/**
 * @typedef {object} Field
 * @property {string} id
 * @property {Key} label
 * @property {'text' | 'email' | 'tel' | 'url' | 'password' | 'decimal' | 'datetime' | 'lines' | 'choice' | 'check'} kind
 * @property {Key} [hint]                               stands below it
 * @property {{ value: string, label: Key }[]} [options]  of a choice; the first is the default
 * @property {boolean} [optional]
 * @property {boolean} [half]                           two of them share a line
 * @property {string} [autocomplete]                    as in HTML; off if left out
 * @property {(values: Values) => boolean} [shownWhen]  left out: always
 */

/**
 * By the field's id. A checkbox is 'true' or ''; a field that is not shown is ''.
 * @typedef {Record<string, string>} Values
 */

/**
 * A warning leaves the content usable.
 * @typedef {{ field: string, severity: 'error' | 'warning', key: Key, values?: Record<string, string | number> }} Problem
 */

/** @typedef {{ payload: string, problems: Problem[] }} Built  `payload` is '' if there is an error */

/**
 * @typedef {object} Content
 * @property {string} id
 * @property {Key} label
 * @property {Field[]} fields
 * @property {(values: Values) => Built} build
 */

export {};
