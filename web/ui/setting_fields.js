// SPDX-License-Identifier: GPL-3.0-or-later
// Converts between settings and the texts in their controls. Most settings have one control; a fixed size has two, the
// choice `fixed` and the number beside it, which otherwise is the largest size. So has a pattern of one's own: the choice
// `own` and the grid below it.
import { kSettings } from '../generated/settings.js';
import { settingFrom, settingText } from '../settings/setting_text.js';

/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */
/** @typedef {import('../settings/work_settings.js').WorkSettings} WorkSettings */
/** @typedef {Exclude<SettingKey, 'text'>} FieldKey */

/** The choice that reads its number from a field. */
export const kFixed = 'fixed';

/** The choice of a pattern that is drawn in its grid, and the pattern that the grid begins with: `thick-plus`. */
export const kOwn = 'own';
export const kFirstMask = '01110/11111/11111/11111/01110';

/** Tells whether the size is a number, not a choice. @param {WorkSettings} settings */
export const isSizeFixed = ({ size }) => typeof size === 'number';

/**
 * Returns the text that a control shows; 'NaN' for a missing number.
 * @param {FieldKey} key  of the control
 * @param {WorkSettings} settings
 */
export function fieldText(key, settings) {
  if (isSizeFixed(settings) && key === 'size') return kFixed;
  if (settings.patternMask && key === 'pattern') return kOwn;
  return settingText(settings[isSizeFixed(settings) && key === 'maxSizeMm' ? 'size' : key]);
}

/**
 * Returns the change that a control asks for.
 * @param {FieldKey} key  of the control
 * @param {string} text   in the control
 * @param {WorkSettings} settings  before the change
 * @param {number} [placedMm]  size of the placed code, which a fixed size begins with
 * @returns {WorkSettings}
 */
export function fieldChange(key, text, settings, placedMm = settings.maxSizeMm) {
  if (key === 'size' && text === kFixed) return { size: placedMm };
  if (key === 'pattern' && text === kOwn) return { patternMask: kFirstMask };
  // The change says so itself: it is shown while it is typed, before settingsAfter() completes it.
  /** @type {WorkSettings} */ const change = {
    [key]: fieldValue(key, text),
    ...(key === 'pattern' && { patternMask: undefined }),
  };
  return key === 'maxSizeMm' && isSizeFixed(settings) ? { size: change.maxSizeMm } : change;
}

/**
 * Returns the value that a control's text stands for.
 * @param {FieldKey} key
 * @param {string} text
 * @returns {any}  undefined: none; NaN: a number is missing
 */
export function fieldValue(key, text) {
  const { kind, mayBeEmpty } = kSettings[key];
  if (text === '' && (mayBeEmpty || kind === 'text' || kind === 'vector')) return undefined;
  const value = settingFrom(key, text);
  return kind === 'number' && typeof value === 'string' ? NaN : value;
}
