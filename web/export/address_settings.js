// SPDX-License-Identifier: GPL-3.0-or-later
// Reads settings from the page's address, by name: `?sample=bunny&pattern=square&light=90,33`.
import { EngineFailure } from '../engine/engine_error.js';
import { lampsFrom } from '../engine/lamps.js';
import { message } from '../engine/message.js';
import { kSettings } from '../generated/settings.js';
import { withoutRemoved } from './removed_settings.js';
import { checkSetting, fileKeys } from './settings_file.js';

/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */

/** @param {import('../engine/message.js').Message} why @returns {never} */
function refuse(why) {
  throw new EngineFailure({ kind: 'BadInput', ...message('settings-address-refused', { why: { cause: why } }) });
}

/** @param {SettingKey} key @param {string} text @returns {unknown} */
function valueOf(key, text) {
  const { kind } = kSettings[key];
  if (kind === 'switch') return text === 'true' ? true : text === 'false' ? false : text;
  if (kind === 'lamps') return lampsFrom(text) ?? text;
  const isNumber =
    (kind === 'number' || kind === 'choice-or-number') && text.trim() !== '' && Number.isFinite(Number(text));
  return isNumber ? Number(text) : text;
}

/**
 * Reads and checks the settings in an address.
 * @param {URLSearchParams} address
 * @param {readonly SettingKey[]} controls  settings that have a control; others are ignored
 * @returns {{ settings: Partial<import('../engine/types.js').Settings>, warnings: import('../engine/message.js').Message[] }}
 *   `warnings`: removed settings, which are ignored
 * @throws {EngineFailure} if a value cannot be used
 */
export function settingsFromAddress(address, controls) {
  const { settings: given, warnings } = withoutRemoved(Object.fromEntries(address));
  const keys = fileKeys(controls).filter((key) => key !== 'text' && key in given);
  const settings = Object.fromEntries(
    keys.map((key) => {
      const value = valueOf(key, address.get(key) ?? '');
      checkSetting(key, value, refuse);
      return [key, value];
    }),
  );
  return { settings, warnings };
}
