// SPDX-License-Identifier: GPL-3.0-or-later
// The controls with `data-setting`, the key of their setting: their labels, bounds and choices. Shows the values and
// reports the user's edits.
import { kSettings } from '../generated/settings.js';
import { onLanguage, text } from '../i18n/catalogue.js';
import { choiceLabel, controlName, settingHint } from '../i18n/setting_names.js';
import { byId, make } from '../dom/dom.js';
import { LampsField } from './lamps_field.js';
import { SettingFields, isWhole, kFixed, kNotANumber, kOneLight, sizeKey, vectorFrom } from './setting_fields.js';
import { TypingPause } from './typing_pause.js';

/** @typedef {HTMLInputElement | HTMLSelectElement} Control */
/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */
/** @typedef {import('../storage/last_work.js').Values} Values */

const kMostListed = 16; // most numbers listed as choices

/**
 * @typedef {object} SettingsListener
 * @property {(id: string, value: string | boolean) => void} onInput   a control is being edited
 * @property {(id: string, value: string | boolean) => void} onChange  an edit is finished
 */

export class SettingsForm {
  constructor() {
    /** @type {SettingsListener | undefined} */ this.listener_ = undefined;
    this.lamps_ = new LampsField();
    this.controls_ = /** @type {Control[]} */ ([...document.querySelectorAll('[data-setting]')]);
    for (const control of this.controls_) {
      prepare(control);
      this.watch_(control);
    }
    /** @type {Values} */
    this.values_ = Object.fromEntries(this.controls_.map((control) => [control.id, heldBy(control)]));
    this.fields = new SettingFields(
      this.controls_.map((control) => ({ id: control.id, key: keyOf(control) })),
      this.values_,
    );
    onLanguage(() => this.nameAll_());
    this.nameAll_();
  }

  /** @param {SettingsListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /** Shows the values of all controls. Leaves a control alone that holds its value already. @param {Values} values */
  show(values) {
    const { light } = this.values_;
    this.values_ = values;
    for (const control of this.controls_) {
      const value = values[control.id];
      if (value === heldBy(control)) continue;
      if (control instanceof HTMLSelectElement) offerVector(control, String(value));
      if (isCheck(control)) control.checked = value === true;
      else control.value = value === kNotANumber ? '' : String(value);
    }
    if (values.light !== light) this.lamps_.read();
    this.follow_();
  }

  /** Reports the edits of a control. A text is edited once typing pauses. @param {Control} control */
  watch_(control) {
    const isText = kSettings[keyOf(control)].kind === 'text';
    const apply = () => this.listener_?.onChange(control.id, heldBy(control));
    const pause = new TypingPause(apply);
    control.addEventListener('input', () => {
      this.listener_?.onInput(control.id, heldBy(control));
      if (isText) pause.typed();
    });
    control.addEventListener('change', () => void (isText ? pause.settle() : apply()));
  }

  nameAll_() {
    this.controls_.forEach(name);
    this.follow_();
  }

  /** Updates the label and the hint that depend on other controls. */
  follow_() {
    const { size, objective, light } = this.values_;
    byId('size-mm-label', HTMLElement).textContent = controlName(sizeKey(size));
    byId('light-hint', HTMLElement).hidden = objective !== kOneLight || light !== '';
  }
}

/** @param {Control} control @returns {control is HTMLInputElement & { type: 'checkbox' }} */
const isCheck = (control) => control instanceof HTMLInputElement && control.type === 'checkbox';

/** @param {Control} control */
function heldBy(control) {
  if (isCheck(control)) return control.checked;
  return control.validity.badInput ? kNotANumber : control.value;
}

/** @param {Control} control */
const keyOf = (control) => /** @type {SettingKey} */ (control.dataset.setting);

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

/** Returns the element of a control's hint. @param {Control} control */
const hintBelow = (control) => document.getElementById(`${control.id}-hint`);

/** Sets a control's choices, bounds and default, and makes room for its hint. @param {Control} control */
function prepare(control) {
  if (settingHint(keyOf(control))) {
    const hint = make('p', { className: 'field-hint' });
    hint.id = `${control.id}-hint`;
    control.after(hint);
    control.setAttribute('aria-describedby', hint.id);
  }
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

/**
 * Adds a choice for a vector, which takes the place of an earlier one.
 * @param {HTMLSelectElement} select
 * @param {string} value  any other value adds none
 */
function offerVector(select, value) {
  if (kSettings[keyOf(select)].kind !== 'choice-or-vector') return;
  for (const option of [...select.options]) if (vectorFrom(option.value)) option.remove();
  if (!vectorFrom(value)) return;
  select.append(Object.assign(make('option'), { value }));
  name(select);
}

/** @param {SettingKey} key @param {number[]} vector */
function vectorLabel(key, vector) {
  if (key !== 'buildUp') return choiceLabel(key, 'vector');
  const axis = vector.findIndex((part) => part !== 0);
  if (vector.filter((part) => part !== 0).length !== 1) return text('settings.faceDown');
  return text('settings.axisUp', { axis: `${vector[axis] > 0 ? '+' : '−'}${'XYZ'[axis]}` });
}

/** Writes a control's label, its hint and the names of its choices. @param {Control} control */
function name(control) {
  const key = keyOf(control),
    label = control.labels?.[0];
  if (label) (label.querySelector('span') ?? label).textContent = controlName(key);
  const said = settingHint(key);
  const hint = said && hintBelow(control); // some controls have a hint of the page's own
  if (hint) hint.textContent = said;
  if (!(control instanceof HTMLSelectElement)) return;
  for (const option of control.options) {
    const vector = vectorFrom(option.value);
    if (vector) {
      option.textContent = vectorLabel(key, vector);
      continue;
    }
    option.textContent = isWhole(option.value)
      ? `${controlName(key)} ${option.value}`
      : choiceLabel(key, option.value === kFixed ? 'number' : option.value);
  }
}
