// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the settings and their choices in the current language (setting_words.js).
import { kSettingGroups, kSettings, kUnits } from '../generated/settings.js';
import { currentLanguage } from './catalogue.js';
import { choiceIn, labelIn, nameIn } from './setting_words.js';

/** Returns the label of the control without its unit: "Minimum wall". @param {string} key  of a setting of the core */
export const controlLabel = (key) => labelIn(currentLanguage(), key);

/** Returns the label of the control with its unit: "Minimum wall (mm)". @param {string} key  of a setting of the core */
export const controlName = (key) => nameIn(currentLanguage(), key);

/** Returns the sentence under the control; '' if it needs none. @param {import('../generated/settings.js').SettingKey} key */
export const settingHint = (key) => kSettings[key].hint?.[currentLanguage()] ?? '';

/** @param {string} key @param {string} value */
export const choiceLabel = (key, value) => choiceIn(currentLanguage(), key, value);

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
