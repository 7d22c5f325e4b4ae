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

export const isKnownSetting = (/** @type {string} */ key) => key in kSettings || key in kOtherControls;

/**
 * Returns the label of the control without its unit: "Minimum wall".
 * @param {Names} names
 * @param {string} key  of a setting of the core
 */
export function labelIn({ settings: { settings }, page }, key) {
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
  const unit = setting?.kind === 'number' ? setting.unit : undefined;
  return withUnit(names, labelIn(names, key), unit);
}

/** Returns the label of the number beside the choices of a setting: "Width (mm)". @param {Names} names @param {string} key */
export const numberNameIn = (names, key) =>
  withUnit(names, names.settings.settings[key].parts?.number ?? key, settingOf(key).unit);

/** @param {Names} names @param {string} label @param {string} [unit] */
const withUnit = (names, label, unit) => (unit ? `${label} (${names.settings.units[unit]})` : label);

/** @param {Names} names @param {string} key @param {string} value */
export function choiceIn({ settings: { settings }, page }, key, value) {
  if (key === 'units' && value in kUnitNames) return page.settings[kUnitNames[value]];
  return settings[key]?.choices?.[value] ?? value;
}
