// SPDX-License-Identifier: GPL-3.0-or-later
// The controls with `data-setting`, the key of their setting: their labels, bounds, choices and values, and the
// settings that they add up to for the engine.
import { EngineFailure } from '../engine/engine_error.js';
import { areLamps, lampsFrom, lampsText } from '../engine/lamps.js';
import { message } from '../engine/message.js';
import { kProcesses, kSettings } from '../generated/settings.js';
import { onLanguage } from '../i18n/catalogue.js';
import { choiceLabel, controlName } from '../i18n/setting_names.js';
import { byId, make } from '../dom/dom.js';
import { LampsField } from './lamps_field.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {HTMLInputElement | HTMLSelectElement} Control */
/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */
/** @typedef {import('../storage/last_work.js').Values} Values */

/** The choice that reads its number from a field. */
const kFixed = 'fixed';

const kMostListed = 16; // most numbers listed as choices

/** The objective that allows a lamp. */
const kOneLight = 'one-light';

export class SettingsForm {
  /** @param {(id: string) => void} onChange  id of the changed control */
  constructor(onChange) {
    this.onChange_ = onChange;
    this.lamps_ = new LampsField();
    this.controls_ = /** @type {Control[]} */ ([...document.querySelectorAll('[data-setting]')]);
    for (const control of this.controls_) {
      prepare(control);
      control.addEventListener('change', () => {
        this.values = this.brought_({ setting: keyOf(control), value: control.value });
        onChange(control.id);
      });
    }
    onLanguage(() => this.nameAll_());
    this.nameAll_();
    this.defaults = this.values;
  }

  /** @returns {Values} */
  get values() {
    return Object.fromEntries(
      this.controls_.map((control) => [control.id, isCheck(control) ? control.checked : control.value]),
    );
  }

  set values(values) {
    for (const control of this.controls_) {
      const value = values[control.id];
      if (value === undefined) continue;
      if (isCheck(control)) control.checked = Boolean(value);
      else if (isPossible(control, String(value))) control.value = String(value);
    }
    this.follow_();
  }

  /** The settings that have a control. @returns {SettingKey[]} */
  get keys() {
    return this.controls_.map(keyOf);
  }

  /** Returns the control values that produce these settings. @param {Settings} settings @returns {Values} */
  valuesFor(settings) {
    return controlValues(
      settings,
      this.controls_.map((control) => ({ id: control.id, key: keyOf(control) })),
      this.defaults,
    );
  }

  /** Sets several controls at once, as if the user had typed the values. @param {Values} values */
  change(values) {
    this.values = values;
    this.onChange_(Object.keys(values)[0]);
  }

  /**
   * @param {string} content  of the code
   * @returns {Settings}
   * @throws {EngineFailure} if a number is missing or out of range
   */
  settings(content) {
    const values = Object.fromEntries(this.controls_.map((control) => [keyOf(control), valueOf(control)]));
    if (values.size === kFixed) values.size = values.maxSizeMm;
    if (values.ecc === 'auto') values.ecc = undefined;
    const given = Object.entries(values).filter(([, value]) => value !== undefined);
    return /** @type {Settings} */ ({ text: content, ...Object.fromEntries(given) });
  }

  /**
   * Finds the control of a setting, and the control's value for a value of the setting.
   * @param {{ setting: string, value: string }} change  `value` '' stands for the setting's default
   */
  controlFor({ setting, value }) {
    const control = this.controls_.find((one) => keyOf(one) === setting);
    if (!control) throw new Error(`no control sets "${setting}"`);
    const hasAuto = control instanceof HTMLSelectElement && value === '';
    return { id: control.id, value: hasAuto ? 'auto' : value };
  }

  /**
   * Returns the values of all controls after a setting changes.
   * @param {{ setting: string, value: string }} change
   * @returns {Values}
   */
  valuesAfter(change) {
    const { id, value } = this.controlFor(change);
    return { ...this.values, [id]: value, ...this.brought_({ ...change, value }) };
  }

  /** @param {{ setting: string, value: string }} change @returns {Values} */
  brought_(change) {
    return Object.fromEntries(
      Object.entries(broughtBy(change)).map(([setting, value]) => [this.controlFor({ setting, value }).id, value]),
    );
  }

  nameAll_() {
    this.controls_.forEach(name);
    this.follow_();
  }

  /** Updates the labels and hints that depend on other controls. */
  follow_() {
    byId('size-mm-label', HTMLElement).textContent = controlName(sizeKey());
    this.lamps_.read();
    byId('light-hint', HTMLElement).hidden =
      choice('objective') !== kOneLight || byId('light', HTMLInputElement).value !== '';
  }
}

/**
 * Returns the settings that a choice changes along with itself: a process sets its printer, and an objective without
 * lamps clears the lamps.
 * @param {{ setting: string, value: string }} change
 * @returns {Record<string, string>}  by setting
 */
export function broughtBy({ setting, value }) {
  if (setting === 'process')
    return Object.fromEntries(Object.entries(kProcesses[value] ?? {}).map(([key, held]) => [key, String(held)]));
  return setting === 'objective' && value !== kOneLight ? { light: '' } : {};
}

/**
 * Returns the control values for these settings, the inverse of `SettingsForm.settings`. A setting that is left out
 * gets its control's default.
 * @param {Settings} settings
 * @param {{ id: string, key: SettingKey }[]} controls
 * @param {Values} defaults
 * @returns {Values}
 */
export function controlValues(settings, controls, defaults) {
  const fixed = typeof settings.size === 'number';
  const given = /** @type {Record<string, unknown>} */ (
    fixed ? { ...settings, size: kFixed, maxSizeMm: settings.size } : settings
  );
  return Object.fromEntries(
    controls.map(({ id, key }) => {
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

/** @param {Control} control @returns {control is HTMLInputElement & { type: 'checkbox' }} */
const isCheck = (control) => control instanceof HTMLInputElement && control.type === 'checkbox';

/** @param {string} id */
const choice = (id) => byId(id, HTMLSelectElement).value;

/** @param {Control} control */
const keyOf = (control) => /** @type {SettingKey} */ (control.dataset.setting);

/** Tells whether a control can have a value: the last visit's choice may be gone. @param {Control} control @param {string} value */
const isPossible = (control, value) =>
  !(control instanceof HTMLSelectElement) || [...control.options].some((option) => option.value === value);

/** Tells whether a choice is a whole number. @param {string} value */
const isWhole = (value) => /^\d+$/.test(value);

/**
 * Returns the choices that stand for a setting's numbers: every number of a short range, otherwise one word for all.
 * @param {SettingKey} key
 * @returns {string[]}
 */
function numbersOf(key) {
  const { whole, min = 0, max = Infinity } = kSettings[key];
  return whole && max - min < kMostListed
    ? Array.from({ length: max - min + 1 }, (_, at) => String(min + at))
    : [kFixed];
}

/** Sets a control's choices, bounds and default. @param {Control} control */
function prepare(control) {
  const { choices = [], kind, min, max, default: initial } = kSettings[keyOf(control)];
  if (control instanceof HTMLSelectElement) {
    const values = kind === 'choice-or-number' ? [...choices, ...numbersOf(keyOf(control))] : choices;
    control.append(
      ...values.map((value) => Object.assign(make('option'), { value, defaultSelected: value === initial })),
    );
  } else if (isCheck(control)) {
    control.defaultChecked = Boolean(initial);
  } else if (kind === 'number') {
    Object.assign(control, { min: String(min), max: String(max) });
    // A field that may be empty begins empty; the page's own defaults are in the markup.
    if (control.required && !control.defaultValue) control.defaultValue = String(initial);
  }
}

/** Writes a control's label and the names of its choices. @param {Control} control */
function name(control) {
  const key = keyOf(control),
    label = control.labels?.[0];
  if (label) (label.querySelector('span') ?? label).textContent = controlName(key);
  if (!(control instanceof HTMLSelectElement)) return;
  for (const option of control.options) {
    option.textContent = isWhole(option.value)
      ? `${controlName(key)} ${option.value}`
      : choiceLabel(key, option.value === kFixed ? 'number' : option.value);
  }
}

/**
 * @param {Control} control
 * @returns {string | number | boolean | import('../engine/lamps.js').Lamp[] | undefined}  undefined if left empty
 * @throws {EngineFailure} if a number is missing or out of range, or a lamp is malformed
 */
function valueOf(control) {
  if (control instanceof HTMLSelectElement) return isWhole(control.value) ? Number(control.value) : control.value;
  if (isCheck(control)) return control.checked;
  if (!control.validity.valid) throw new EngineFailure({ kind: 'BadUsage', ...whyInvalid(control) });
  if (kSettings[keyOf(control)].kind === 'lamps') return lampsOf(control);
  return control.value === '' ? undefined : control.valueAsNumber;
}

/** @param {HTMLInputElement} control @returns {import('../engine/lamps.js').Lamp[] | undefined} */
function lampsOf(control) {
  const { value } = control,
    lamps = lampsFrom(value);
  if (lamps) return lamps.length > 0 ? lamps : undefined;
  throw new EngineFailure({
    kind: 'BadUsage',
    ...message('setting-no-lamps', { setting: { setting: keyOf(control) }, found: { quoted: value } }),
  });
}

/** @param {HTMLInputElement} input */
function whyInvalid(input) {
  const { min, max, value } = input,
    key = keyOf(input);
  const setting = { setting: key === 'maxSizeMm' ? sizeKey() : key };
  const from = { number: Number(min) };
  const to = { number: Number(max) };
  return value === ''
    ? message('control-not-a-number', { setting, from, to })
    : message('control-out-of-range', { setting, from, to, value: { number: Number(value) } });
}

const sizeKey = () => (choice('size') === kFixed ? 'sizeMm' : 'maxSizeMm');
