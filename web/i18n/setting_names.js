// SPDX-License-Identifier: GPL-3.0-or-later
// The page's names of the settings and their choices. The words come with the table of settings. Controls that messages
// mention but that are no core settings have their names here.
import { kSettingGroups, kSettings, kUnits } from '../generated/settings.js';
import { currentLanguage, text } from './catalogue.js';

/** @typedef {import('./catalogue.js').Key} Key */
/** @typedef {import('../generated/settings.js').Setting} Setting */

/** @type {Record<string, Key>} */
const kOtherControls = {
  centreMm: 'settings.centre',
  units: 'settings.unit',
  unit: 'settings.unit',
  scale: 'settings.unit',
  upAxis: 'settings.upAxis',
};
const kUnitNames = /** @type {const} */ ({ m: 'settings.metres', cm: 'settings.centimetres', in: 'settings.inches' });

/** @param {string} key @returns {Setting | undefined} */
const settingOf = (key) => /** @type {Record<string, Setting>} */ (kSettings)[key];

/**
 * Returns the label of a number that has its own control next to the setting's choices: "sizeMm".
 * @param {string} key
 */
const numberBeside = (key) => (key === 'sizeMm' ? kSettings.size.partLabels?.number : undefined);

export const isKnownSetting = (/** @type {string} */ key) =>
  key in kSettings || key in kOtherControls || numberBeside(key) !== undefined;

/** Returns the label of the control without its unit: "Minimum wall". @param {string} key  of a setting of the core */
export function controlLabel(key) {
  const words = settingOf(key)?.label ?? numberBeside(key);
  if (words) return words[currentLanguage()];
  return key in kOtherControls ? text(kOtherControls[key]).replace(/ \([^)]*\)$/, '') : key;
}

/**
 * Returns the label of the control with its unit: "Minimum wall (mm)".
 * @param {string} key  of a setting of the core
 */
export function controlName(key) {
  if (key in kOtherControls) return text(kOtherControls[key]);
  const setting = settingOf(key);
  const unit = setting?.kind === 'number' ? setting.unit : numberBeside(key) && 'mm';
  return unit ? `${controlLabel(key)} (${kUnits[unit][currentLanguage()]})` : controlLabel(key);
}

/** @param {string} key @param {string} value */
export function choiceLabel(key, value) {
  if (key === 'units' && value in kUnitNames) return text(kUnitNames[/** @type {keyof typeof kUnitNames} */ (value)]);
  return settingOf(key)?.choiceNames?.[value]?.[currentLanguage()] ?? value;
}

/**
 * Returns the texts of all settings by the keys that the engine uses (app/inspector/setting_labels.h).
 * @returns {Record<string, string>}
 */
export function settingTexts() {
  const language = currentLanguage();
  /** @type {Record<string, string>} */
  const texts = {};
  for (const [key, { kind, label, choiceNames = {}, partLabels = {} }] of Object.entries(kSettings)) {
    texts[`setting:${key}`] = label[language];
    for (const [choice, name] of Object.entries(choiceNames)) texts[`choice:${key}:${choice}`] = name[language];
    for (const [part, name] of Object.entries(partLabels)) {
      if (kind !== 'lamps') texts[`setting:${key}.${part}`] = name[language];
      else
        for (const lamp of [1, 2])
          texts[`setting:${key}.${lamp}.${part}`] = `${label[language]} ${lamp}, ${name[language]}`;
    }
  }
  for (const [key, name] of Object.entries(kSettingGroups)) texts[`group:${key}`] = name[language];
  for (const [key, name] of Object.entries(kUnits)) texts[`unit:${key}`] = name[language];
  return texts;
}
