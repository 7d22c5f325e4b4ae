// SPDX-License-Identifier: GPL-3.0-or-later
// Messages without words: a code and its values, as core/base/message_json.h writes them. The words are in
// locales/; web/i18n/sentences.js makes the sentences.

/**
 * A value of a message. Its kind decides its format.
 * @typedef {{ count: number } | { index: number } | { number: number } | { lengthMm: number } | { angleDeg: number }
 *   | { fraction: number } | { place: number[] } | { extentMm: number[] } | { quoted: string } | { term: string } | { setting: string }
 *   | { choice: { key: string, value: string } } | { indices: number[] } | { cause: Message }} Value
 * @typedef {{ code: string, values: Record<string, Value> }} Message
 */

/**
 * Makes a message, as in `message('engine-hung', { count: { count: 3 } })`. `npm run lint` checks that locales/ has the
 * code and these values (script/message_rule.js).
 * @param {string} code  a literal
 * @param {Record<string, Value>} [values]  by literal names
 * @returns {Message}
 */
export const message = (code, values = {}) => ({ code, values });
