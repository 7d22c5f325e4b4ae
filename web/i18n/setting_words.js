// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the settings and their choices in a language. The words come with the table of settings. Controls that
// messages mention but that are no core settings have their names here.
import { kSettings, kUnits } from '../generated/settings.js';
import { settings } from './parts/settings.js';

/** @typedef {import('../generated/settings.js').Setting} Setting */
/** @typedef {import('./languages.js').Language} Language */

/** @type {Record<string, keyof typeof settings.en>} */
const kOtherControls = { centreMm: 'centre', units: 'unit', unit: 'unit', scale: 'unit', upAxis: 'upAxis' };
const kUnitNames = /** @type {const} */ ({
  m: 'metres',
  cm: 'centimetres',
  mm: 'millimetres',
  in: 'inches',
  um: 'micrometres',
});

/** @param {string} key @returns {Setting | undefined} */
const settingOf = (key) => /** @type {Record<string, Setting>} */ (kSettings)[key];

/**
 * Returns the label of a number that has its own control next to the setting's choices: "sizeMm".
 * @param {string} key
 */
const numberBeside = (key) => (key === 'sizeMm' ? kSettings.size.partLabels?.number : undefined);

export const isKnownSetting = (/** @type {string} */ key) =>
  key in kSettings || key in kOtherControls || numberBeside(key) !== undefined;

/**
 * Returns the label of the control without its unit: "Minimum wall".
 * @param {Language} language
 * @param {string} key  of a setting of the core
 */
export function labelIn(language, key) {
  const words = settingOf(key)?.label ?? numberBeside(key);
  if (words) return words[language];
  return key in kOtherControls ? settings[language][kOtherControls[key]].replace(/ \([^)]*\)$/, '') : key;
}

/**
 * Returns the label of the control with its unit: "Minimum wall (mm)".
 * @param {Language} language
 * @param {string} key  of a setting of the core
 */
export function nameIn(language, key) {
  if (key in kOtherControls) return settings[language][kOtherControls[key]];
  const setting = settingOf(key);
  const unit = setting?.kind === 'number' ? setting.unit : numberBeside(key) && 'mm';
  return unit ? `${labelIn(language, key)} (${kUnits[unit][language]})` : labelIn(language, key);
}

/** @param {Language} language @param {string} key @param {string} value */
export function choiceIn(language, key, value) {
  if (key === 'units' && value in kUnitNames)
    return settings[language][kUnitNames[/** @type {keyof typeof kUnitNames} */ (value)]];
  return settingOf(key)?.choiceNames?.[value]?.[language] ?? value;
}
