// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the settings and their choices in the current language (setting_words.js).
import { areLamps, lampsText } from '../engine/lamps.js';
import { kSettings } from '../generated/settings.js';
import { appTexts, text } from './catalogue.js';
import { formatPlain } from './format.js';
import { choiceIn, labelIn, nameIn, numberNameIn } from './setting_words.js';

const names = /** @type {() => import('./setting_words.js').Names} */ (appTexts);

/** Returns the label of the control without its unit: "Minimum wall". @param {string} key  of a setting of the core */
export const controlLabel = (key) => labelIn(names(), key);

/** Returns the label of the control with its unit: "Minimum wall (mm)". @param {string} key  of a setting of the core */
export const controlName = (key) => nameIn(names(), key);

/** Returns the sentence under the control; '' if it needs none. @param {string} key */
export const settingHint = (key) => names().settings.settings[key].hint ?? '';

/** @param {string} key @param {string} value */
export const choiceLabel = (key, value) => choiceIn(names(), key, value);

/** Returns the label of the number beside the choices of a setting: "Width (mm)". @param {string} key */
export const numberName = (key) => numberNameIn(names(), key);

/**
 * Returns a value as its control shows it.
 * @param {string} key
 * @param {unknown} value  undefined: none
 * @returns {string}
 */
export function valueName(key, value) {
  const { choices, whole } = kSettings[/** @type {import('../generated/settings.js').SettingKey} */ (key)];
  if (key === 'light') return areLamps(value) && value.length > 0 ? lampsText(value) : text('settings.evenLight');
  if (value === undefined) return text(key === 'up' ? 'settings.modelUp' : 'settings.auto');
  if (Array.isArray(value)) return vectorName(key, value);
  if (typeof value !== 'number') return choiceLabel(key, String(value));
  return choices && whole ? `${controlName(key)} ${value}` : formatPlain(value);
}

/** @param {string} key @param {number[]} vector */
function vectorName(key, vector) {
  const axis = axisName(vector);
  if (key === 'up') return axis ?? `(${vector.map((part) => formatPlain(part)).join(appTexts().format.between)})`;
  if (key !== 'buildUp') return choiceLabel(key, 'vector');
  return axis ? text('settings.axisUp', { axis }) : text('settings.faceDown');
}

/** Returns the axis along which a vector points, such as "−Z"; undefined: none. @param {number[]} vector */
function axisName(vector) {
  const [axis, ...others] = [0, 1, 2].filter((at) => vector[at] !== 0);
  return others.length === 0 ? `${vector[axis] > 0 ? '+' : '−'}${'XYZ'[axis]}` : undefined;
}

/**
 * Returns the texts of all settings by the keys that the engine uses (app/inspector/setting_labels.h).
 * @returns {Record<string, string>}
 */
export function settingTexts() {
  const { settings, groups, units } = names().settings;
  /** @type {Record<string, string>} */
  const texts = {};
  for (const [key, { kind }] of Object.entries(kSettings)) {
    const { label, choices = {}, parts = {} } = settings[key];
    texts[`setting:${key}`] = label;
    for (const [choice, name] of Object.entries(choices)) texts[`choice:${key}:${choice}`] = name;
    for (const [part, name] of Object.entries(parts)) {
      if (kind !== 'lamps') texts[`setting:${key}.${part}`] = name;
      else for (const lamp of [1, 2]) texts[`setting:${key}.${lamp}.${part}`] = `${label} ${lamp}, ${name}`;
    }
  }
  for (const [key, name] of Object.entries(groups)) texts[`group:${key}`] = name;
  for (const [key, name] of Object.entries(units)) texts[`unit:${key}`] = name;
  return texts;
}
