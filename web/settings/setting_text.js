// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the values of settings from and into text, as in addresses and in the changes of a remedy
// (core/settings/setting_text.h).
import { lampsFrom, lampsText } from '../engine/lamps.js';
import { kSettings } from '../generated/settings.js';

/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */

/**
 * Parses a value. A text that the setting cannot have comes back as it is, for `settingProblem` to name it.
 * @param {SettingKey} key
 * @param {string} text
 * @returns {unknown}
 */
export function settingFrom(key, text) {
  const { kind } = kSettings[key];
  if (kind === 'switch') return text === 'true' ? true : text === 'false' ? false : text;
  if (kind === 'lamps') return lampsFrom(text) ?? text;
  if (kind === 'vector' || kind === 'choice-or-vector') return vectorFrom(text) ?? text;
  return (kind === 'number' || kind === 'choice-or-number') && isNumber(text) ? Number(text) : text;
}

/** Writes a value as `settingFrom` reads it; '' for none. @param {unknown} value  of a setting */
export const settingText = (value) => (isList(value) ? lampsText(value) : String(value ?? ''));

/** Tells whether a value is a list of lamps, even of unfinished ones. @param {unknown} value @returns {value is import('../engine/lamps.js').Lamp[]} */
const isList = (value) => Array.isArray(value) && value.every((part) => typeof part === 'object');

/** @param {string} text */
const isNumber = (text) => text.trim() !== '' && Number.isFinite(Number(text));

/** @param {string} text  "0,0,1" @returns {number[] | undefined} */
function vectorFrom(text) {
  const parts = text.split(',');
  return parts.length === 3 && parts.every(isNumber) ? parts.map(Number) : undefined;
}
