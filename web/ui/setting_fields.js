// SPDX-License-Identifier: GPL-3.0-or-later
// Values of the settings' controls: converts them into the engine's settings and back, and computes them after a change.
import { EngineFailure } from '../engine/engine_error.js';
import { areLamps, lampsFrom, lampsText } from '../engine/lamps.js';
import { message } from '../engine/message.js';
import { kProcesses, kSettings } from '../generated/settings.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */
/** @typedef {import('../storage/last_work.js').Values} Values */
/** @typedef {{ id: string, key: SettingKey }} Field  a control and its setting */
/** @typedef {{ setting: string, value: string }} Change  `value` '' stands for the setting's default */

/** The choice that reads its number from a field. */
export const kFixed = 'fixed';

/** The objective that allows a lamp. */
export const kOneLight = 'one-light';

/** The value of a field whose text is no number. */
export const kNotANumber = '?';

export class SettingFields {
  /** @param {Field[]} fields @param {Values} defaults */
  constructor(fields, defaults) {
    this.fields_ = fields;
    this.defaults = defaults;
  }

  /** The settings that have a control. @returns {SettingKey[]} */
  get keys() {
    return this.fields_.map(({ key }) => key);
  }

  /**
   * Returns the engine's settings.
   * @param {Values} values
   * @param {string} content  of the code
   * @returns {Settings}
   * @throws {EngineFailure} if a number is missing or out of range, or a lamp is malformed
   */
  settings(values, content) {
    const given = Object.fromEntries(this.fields_.map(({ id, key }) => [key, settingOf(key, values[id], values.size)]));
    if (given.size === kFixed) given.size = given.maxSizeMm;
    if (given.ecc === 'auto') given.ecc = undefined;
    if (given.content === 'text') given.label = undefined; // its control is hidden
    const known = Object.entries(given).filter(([, value]) => value !== undefined);
    return /** @type {Settings} */ ({ text: content, ...Object.fromEntries(known) });
  }

  /** Returns the values that produce these settings. @param {Settings} settings @returns {Values} */
  valuesFor(settings) {
    return controlValues(settings, this.fields_, this.defaults);
  }

  /**
   * Finds the control of a setting, and the control's value for a value of the setting.
   * @param {Change} change
   */
  controlFor({ setting, value }) {
    const field = this.fields_.find(({ key }) => key === setting);
    if (!field) throw new Error(`no control sets "${setting}"`);
    return { id: field.id, value: isChoice(field.key) && value === '' ? 'auto' : value };
  }

  /** Returns the values after a setting changes. @param {Values} values @param {Change} change @returns {Values} */
  after(values, change) {
    const { id, value } = this.controlFor(change);
    return this.edited(values, id, isSwitch(change.setting) ? value === 'true' : value);
  }

  /**
   * Returns the values after a control is edited.
   * @param {Values} values
   * @param {string} id
   * @param {string | boolean} value
   * @returns {Values}
   */
  edited(values, id, value) {
    const setting = this.fields_.find((field) => field.id === id)?.key ?? '';
    const brought = Object.entries(broughtBy({ setting, value: String(value) })).map(([key, own]) => {
      const control = this.controlFor({ setting: key, value: own });
      return [control.id, control.value];
    });
    return { ...values, [id]: value, ...Object.fromEntries(brought) };
  }

  /**
   * Returns the values after others are restored. A control without a possible restored value keeps its own.
   * @param {Values} values
   * @param {Values} restored  may come from another version of the page
   * @returns {Values}
   */
  restored(values, restored) {
    const known = this.fields_
      .filter(({ id, key }) => isPossible(key, restored[id]))
      .map(({ id }) => [id, restored[id] === kNotANumber ? '' : restored[id]]);
    return { ...values, ...Object.fromEntries(known) };
  }
}

/**
 * Returns the settings that a choice also changes: a process sets its printer, and an objective without
 * lamps clears the lamps.
 * @param {Change} change
 * @returns {Record<string, string>}  by setting
 */
export function broughtBy({ setting, value }) {
  if (setting === 'process')
    return Object.fromEntries(Object.entries(kProcesses[value] ?? {}).map(([key, held]) => [key, String(held)]));
  return setting === 'objective' && value !== kOneLight ? { light: '' } : {};
}

/**
 * Returns the control values for these settings, the inverse of `SettingFields.settings`. A setting that is left out
 * gets its control's default.
 * @param {Settings} settings
 * @param {Field[]} fields
 * @param {Values} defaults
 * @returns {Values}
 */
export function controlValues(settings, fields, defaults) {
  const fixed = typeof settings.size === 'number';
  const given = /** @type {Record<string, unknown>} */ (
    fixed ? { ...settings, size: kFixed, maxSizeMm: settings.size } : settings
  );
  return Object.fromEntries(
    fields.map(({ id, key }) => {
      const value = given[key];
      return [
        id,
        value === undefined
          ? defaults[id]
          : typeof value === 'boolean'
            ? value
            : areLamps(value)
              ? lampsText(value)
              : String(value),
      ];
    }),
  );
}

/** Tells whether a choice is a whole number. @param {string} value */
export const isWhole = (value) => /^\d+$/.test(value);

/**
 * Returns the vector that a control's value stands for: "0,0,1".
 * @param {string} value
 * @returns {number[] | undefined}  undefined for any other value
 */
export function vectorFrom(value) {
  const parts = value.split(',').map((part) => (part.trim() === '' ? NaN : Number(part)));
  return parts.length === 3 && parts.every(Number.isFinite) ? parts : undefined;
}

/** @param {Values['']} size  the chosen kind of size */
export const sizeKey = (size) => (size === kFixed ? 'sizeMm' : 'maxSizeMm');

/** @param {SettingKey} key */
const isChoice = (key) => kSettings[key].kind.startsWith('choice');

/** Tells whether a setting can have a value: a choice may be gone. @param {SettingKey} key @param {Values['']} [value] */
function isPossible(key, value) {
  const { kind, choices } = kSettings[key];
  if (value === undefined) return false;
  return (
    !choices ||
    choices.includes(String(value)) ||
    (kind === 'choice-or-number' && isNumberChoice(String(value))) ||
    (kind === 'choice-or-vector' && vectorFrom(String(value)) !== undefined)
  );
}

/** @param {string} value */
const isNumberChoice = (value) => isWhole(value) || value === kFixed;

/** @param {string} key */
const isSwitch = (key) => kSettings[/** @type {SettingKey} */ (key)].kind === 'switch';

/**
 * Returns a setting for the value of its control.
 * @param {SettingKey} key
 * @param {Values['']} value
 * @param {Values['']} size  the chosen kind of size
 * @returns {string | number | boolean | number[] | import('../engine/lamps.js').Lamp[] | undefined}  undefined if left
 *   empty
 */
function settingOf(key, value, size) {
  if (typeof value === 'boolean') return value;
  if (kSettings[key].kind === 'text') return value === '' ? undefined : value;
  if (kSettings[key].kind === 'choice-or-vector') return vectorFrom(value) ?? value;
  if (isChoice(key)) return isWhole(value) ? Number(value) : value;
  if (kSettings[key].kind === 'lamps') return lampsOf(key, value);
  return numberOf(key, value, size);
}

/** @param {SettingKey} key @param {string} value @param {Values['']} size @returns {number | undefined} */
function numberOf(key, value, size) {
  const { min = -Infinity, max = Infinity, whole, mayBeEmpty } = kSettings[key];
  if (value === '' && mayBeEmpty) return undefined;
  const number = value === '' ? NaN : Number(value);
  if (number >= min && number <= max && (!whole || Number.isInteger(number))) return number;
  const setting = { setting: key === 'maxSizeMm' ? sizeKey(size) : key };
  const [from, to] = [{ number: min }, { number: max }];
  const why = Number.isNaN(number)
    ? message('control-not-a-number', { setting, from, to })
    : message('control-out-of-range', { setting, from, to, value: { number } });
  throw new EngineFailure({ kind: 'BadUsage', ...why });
}

/** @param {SettingKey} key @param {string} value @returns {import('../engine/lamps.js').Lamp[] | undefined} */
function lampsOf(key, value) {
  const lamps = lampsFrom(value);
  if (lamps) return lamps.length > 0 ? lamps : undefined;
  throw new EngineFailure({
    kind: 'BadUsage',
    ...message('setting-no-lamps', { setting: { setting: key }, found: { quoted: value } }),
  });
}
