// SPDX-License-Identifier: GPL-3.0-or-later
// Types of a kind of content: the fields to fill in and the resulting text of the QR code. No program code.

/** @typedef {import('../i18n/catalogue.js').Key} Key */

/**
 * @typedef {object} Field
 * @property {string} id
 * @property {Key} label
 * @property {'text' | 'email' | 'tel' | 'url' | 'password' | 'decimal' | 'datetime' | 'lines' | 'choice' | 'check'} kind
 * @property {Key} [hint]                               shown below the field
 * @property {{ value: string, label: Key }[]} [options]  of a choice; the first is the default
 * @property {boolean} [optional]
 * @property {boolean} [half]                           two such fields share a line
 * @property {string} [autocomplete]                    as in HTML; default: off
 * @property {(values: Values) => boolean} [shownWhen]  default: always
 */

/**
 * Values by field id. A checkbox is 'true' or ''; a hidden field is ''.
 * @typedef {Record<string, string>} Values
 */

/**
 * A problem of a field. A warning leaves the content usable.
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
