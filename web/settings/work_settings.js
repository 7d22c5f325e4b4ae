// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of a work, by their keys and with the values of settings files.
import { EngineFailure } from '../engine/engine_error.js';
import { kProcesses, kSettings } from '../generated/settings.js';
import { settingProblem } from './setting_problem.js';
import { settingFrom, settingText } from './setting_text.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */
/**
 * Settings without a value are absent or undefined. While the user types, a number may be out of range, or NaN where it
 * is missing; `settingProblem` says so.
 * @typedef {Omit<Settings, 'text'>} WorkSettings
 */

/** The objective that allows a lamp. */
export const kOneLight = 'one-light';

/** Returns the defaults of some settings. @param {readonly SettingKey[]} keys @returns {WorkSettings} */
export const defaultsOf = (keys) => Object.fromEntries(keys.map((key) => [key, defaultOf(key)]));

/** @param {SettingKey} key @returns {unknown}  undefined: the setting begins without a value */
function defaultOf(key) {
  if (key === 'up') return undefined; // the engine then takes the axis that is up in the view
  const { default: initial } = kSettings[key];
  return settingText(initial) === '' ? undefined : initial;
}

/** @param {WorkSettings} a @param {WorkSettings} b */
export const sameSettings = (a, b) =>
  keysOf({ ...a, ...b }).every((key) => settingText(a[key]) === settingText(b[key]));

/**
 * Returns the settings after a change, with those that it also changes: a process sets its printer, a pattern clears a
 * pattern of one's own, and an objective without lamps clears the lamps.
 * @param {WorkSettings} settings
 * @param {WorkSettings} change
 * @returns {WorkSettings}
 */
export function settingsAfter(settings, change) {
  const printer = change.process === undefined ? {} : kProcesses[change.process];
  const own = change.pattern === undefined ? {} : { patternMask: change.patternMask };
  const isDark = change.objective !== undefined && change.objective !== kOneLight;
  return { ...settings, ...change, ...printer, ...own, ...(isDark && { light: undefined }) };
}

/**
 * Returns a change that the engine proposes.
 * @param {import('../engine/types.js').SettingChange} change  with the value '' for the default
 * @returns {WorkSettings}
 */
export function proposedChange({ setting, value }) {
  const key = /** @type {SettingKey} */ (setting);
  if (!kSettings[key]) throw new Error(`there is no setting "${setting}"`);
  return { [key]: value === '' ? defaultOf(key) : settingFrom(key, value) };
}

/**
 * Returns the settings of an earlier work. One without a value, or with a choice that is gone, gets its default.
 * @param {WorkSettings} earlier
 * @param {WorkSettings} defaults  of the settings to return
 * @returns {WorkSettings}
 */
export const restoredSettings = (earlier, defaults) =>
  Object.fromEntries(
    keysOf(defaults).map((key) => [key, isPossible(key, earlier[key]) ? earlier[key] : defaults[key]]),
  );

/**
 * Returns the settings for the engine.
 * @param {WorkSettings} settings
 * @param {string} text  of the code
 * @returns {Settings}
 * @throws {EngineFailure} if a setting cannot have its value
 */
export function requestedSettings(settings, text) {
  // A text alone takes no label; the label's control is hidden.
  const keys = keysOf(settings).filter((key) => key !== 'label' || settings.content !== 'text');
  const given = keys.filter((key) => settings[key] !== undefined).map((key) => [key, settings[key]]);
  for (const [key, value] of given) {
    const problem = settingProblem(/** @type {SettingKey} */ (key), value);
    if (problem) throw new EngineFailure({ kind: 'BadUsage', ...problem });
  }
  return { text, ...Object.fromEntries(given) };
}

/**
 * Returns the settings for another model. A size and a rotation made for one model do not follow to the next, which
 * begins with the largest code that fits; those that were asked for do.
 * @param {WorkSettings} settings
 * @param {WorkSettings} asked  by the page's address or a settings file
 * @returns {WorkSettings}
 */
export function settingsForAnother(settings, asked) {
  const { size, rotateDeg } = defaultsOf(['size', 'rotateDeg']);
  if (typeof settings.size !== 'number' && settings.rotateDeg === rotateDeg) return settings;
  return {
    ...settings,
    size: settings.size === asked.size ? asked.size : size, // turning by hand has changed `best` to `oriented`
    rotateDeg: settings.rotateDeg === asked.rotateDeg ? asked.rotateDeg : rotateDeg,
  };
}

/** @param {WorkSettings} settings */
export const keysOf = (settings) => /** @type {(keyof WorkSettings)[]} */ (Object.keys(settings));

/** @param {SettingKey} key @param {unknown} value */
function isPossible(key, value) {
  if (value === undefined || Number.isNaN(value)) return false;
  return !kSettings[key].choices || settingProblem(key, value) === undefined;
}
