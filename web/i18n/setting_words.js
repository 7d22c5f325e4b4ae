// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the settings and their choices, from the texts of a language. Controls that messages mention but that are
// no core settings have their names among the page's texts.
import { kSettings } from '../generated/settings.js';

/** @typedef {{ label: string, hint?: string, choices?: Record<string, string>, parts?: Record<string, string> }} SettingWords */
/**
 * What this needs of a language's texts.
 * @typedef {object} Names
 * @property {{ settings: Record<string, SettingWords>, units: Record<string, string>, groups: Record<string, string> }} settings
 * @property {{ settings: Record<string, string> }} page
 */

/** @type {Record<string, string>} */
const kOtherControls = { centreMm: 'centre', units: 'unit', unit: 'unit', scale: 'unit', upAxis: 'upAxis' };
/** @type {Record<string, string>} */
const kUnitNames = { m: 'metres', cm: 'centimetres', mm: 'millimetres', in: 'inches', um: 'micrometres' };

const settingOf = (/** @type {string} */ key) =>
  /** @type {Record<string, import('../generated/settings.js').Setting>} */ (kSettings)[key];

export const isKnownSetting = (/** @type {string} */ key) =>
  key in kSettings || key in kOtherControls || key === 'sizeMm';

/**
 * Returns the label of the control without its unit: "Minimum wall". "sizeMm" is the number beside the choices of `size`.
 * @param {Names} names
 * @param {string} key  of a setting of the core
 */
export function labelIn({ settings: { settings }, page }, key) {
  if (key === 'sizeMm') return settings.size.parts?.number ?? key;
  if (key in kOtherControls) return page.settings[kOtherControls[key]].replace(/ \([^)]*\)$/, '');
  return settings[key]?.label ?? key;
}

/**
 * Returns the label of the control with its unit: "Minimum wall (mm)".
 * @param {Names} names
 * @param {string} key  of a setting of the core
 */
export function nameIn(names, key) {
  if (key in kOtherControls) return names.page.settings[kOtherControls[key]];
  const setting = settingOf(key);
  const unit = key === 'sizeMm' ? 'mm' : setting?.kind === 'number' ? setting.unit : undefined;
  return unit ? `${labelIn(names, key)} (${names.settings.units[unit]})` : labelIn(names, key);
}

/** @param {Names} names @param {string} key @param {string} value */
export function choiceIn({ settings: { settings }, page }, key, value) {
  if (key === 'units' && value in kUnitNames) return page.settings[kUnitNames[value]];
  return settings[key]?.choices?.[value] ?? value;
}
