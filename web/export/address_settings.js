// SPDX-License-Identifier: GPL-3.0-or-later
// Settings and model in the page's address, by name: `?sample=bunny&at=6.3,-36.2,41.1&pattern=square&light=90,33`.
import { EngineFailure } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { settingProblem } from '../settings/setting_problem.js';
import { settingFrom, settingText } from '../settings/setting_text.js';
import { fileKeys } from './settings_file.js';

/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */
/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {import('./settings_file.js').ModelChoice} ModelChoice */
/** @typedef {[number, number, number]} Point */

const kSpotDigits = 2; // a hundredth of a millimetre

/** @param {import('../engine/message.js').Message} why @returns {never} */
function refuse(why) {
  throw new EngineFailure({ kind: 'BadInput', ...message('settings-address-refused', { why: { cause: why } }) });
}

/**
 * Reads and checks the settings in an address.
 * @param {URLSearchParams} address
 * @param {readonly SettingKey[]} controls  settings that have a control; others are ignored
 * @returns {Partial<Settings>}
 * @throws {EngineFailure} if a value cannot be used
 */
export function settingsFromAddress(address, controls) {
  const keys = fileKeys(controls).filter((key) => key !== 'text' && address.has(key));
  return Object.fromEntries(
    keys.map((key) => {
      const value = settingFrom(key, address.get(key) ?? '');
      const problem = settingProblem(key, value);
      if (problem) refuse(problem);
      return [key, value];
    }),
  );
}

/**
 * Returns the spot on the sample that an address asks for, in mm.
 * @param {URLSearchParams} address
 * @returns {Point | undefined}  undefined: none, or not three numbers
 */
export function spotFromAddress(address) {
  const numbers = (address.get('at') ?? '').split(',').map((part) => (part.trim() === '' ? NaN : Number(part)));
  return numbers.length === 3 && numbers.every(Number.isFinite) ? /** @type {Point} */ (numbers) : undefined;
}

/**
 * Returns the parameters that set the page up: the text, the sample with its spot, and the settings that differ from the
 * defaults. Other models cannot be in an address.
 * @param {{ settings: Settings, defaults: Settings, model?: ModelChoice }} work
 * @returns {URLSearchParams}
 */
export function addressFor({ settings, defaults, model }) {
  const changed = /** @type {[string, unknown][]} */ (Object.entries(settings)).filter(
    ([key, value]) => key !== 'text' && settingText(value) !== settingText(/** @type {any} */ (defaults)[key]),
  );
  const { sample, centreMm } = model ?? {};
  return new URLSearchParams([
    ...(sample ? [['sample', sample]] : []),
    ...(sample && centreMm ? [['at', centreMm.map((mm) => Number(mm.toFixed(kSpotDigits))).join(',')]] : []),
    ['text', settings.text],
    ...changed.map(([key, value]) => [key, settingText(value)]),
  ]);
}
