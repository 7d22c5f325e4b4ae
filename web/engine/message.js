// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be told, without words: a code and its values, as core/base/message_json.h writes them. The words stand in
// messages/*.json; web/i18n/messages.js makes sentences of them.

/**
 * A value by its kind, which decides how it is written.
 * @typedef {{ count: number } | { number: number } | { lengthMm: number } | { angleDeg: number } | { fraction: number }
 *   | { place: number[] } | { extentMm: number[] } | { quoted: string } | { term: string } | { setting: string }
 *   | { choice: { key: string, value: string } } | { indices: number[] } | { cause: Message }} Value
 * @typedef {{ code: string, values: Record<string, Value> }} Message
 */

/**
 * The only maker of messages, so that a test finds them all in the sources: `message('engine-hung', { count: { count: 3 } })`.
 * @param {string} code  a literal
 * @param {Record<string, Value>} [values]  by literal names
 * @returns {Message}
 */
export const message = (code, values = {}) => ({ code, values });
