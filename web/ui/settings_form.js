// SPDX-License-Identifier: GPL-3.0-or-later
// The controls with `data-setting`, the key of their setting: their labels, bounds and choices. Shows the settings and
// reports the user's edits.
import { kSettings } from '../generated/settings.js';
import { onLanguage } from '../i18n/catalogue.js';
import { choiceLabel, controlLabel, controlName, numberName, settingHint, valueName } from '../i18n/setting_names.js';
import { byId, make } from '../dom/dom.js';
import { settingFrom, settingText } from '../settings/setting_text.js';
import { defaultsOf, kOneLight } from '../settings/work_settings.js';
import { FilamentField } from './filament_field.js';
import { LampsField } from './lamps_field.js';
import { PatternField } from './pattern_field.js';
import { fieldChange, fieldText, fieldValue, isSizeFixed, kFixed, kOwn } from './setting_fields.js';
import { TypingPause } from './typing_pause.js';

/** @typedef {HTMLInputElement | HTMLSelectElement} Control */
/** @typedef {import('./setting_fields.js').FieldKey} FieldKey */
/** @typedef {import('../settings/work_settings.js').WorkSettings} WorkSettings */

const kMostListed = 16; // most numbers listed as choices
const kAxes = ['1,0,0', '-1,0,0', '0,1,0', '0,-1,0', '0,0,1', '0,0,-1'];

/**
 * @typedef {object} SettingsListener
 * @property {(change: WorkSettings) => void} onInput   a control is being edited; its setting comes first
 * @property {(change: WorkSettings) => void} onChange  an edit is finished
 */

export class SettingsForm {
  constructor() {
    /** @type {SettingsListener | undefined} */ this.listener_ = undefined;
    this.lamps_ = new LampsField();
    this.filament_ = new FilamentField();
    this.pattern_ = new PatternField();
    this.controls_ = /** @type {Control[]} */ ([...document.querySelectorAll('[data-setting]')]);
    for (const control of this.controls_) {
      prepare(control);
      this.watch_(control);
    }
    /** @type {number | undefined} */ this.placedMm_ = undefined;
    /** The defaults of the settings that have a control. */
    this.defaults = this.settings_ = defaultsOf(this.controls_.map(keyOf));
    this.show(this.defaults);
    onLanguage(() => this.nameAll_());
    this.nameAll_();
  }

  /** @param {SettingsListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /** Shows the settings. Leaves a control alone that holds its value already. @param {WorkSettings} settings */
  show(settings) {
    this.settings_ = settings;
    for (const control of this.controls_) {
      const shown = fieldText(keyOf(control), settings);
      if (shown !== settingText(this.valueIn_(control))) this.fill_(control, shown);
    }
    this.follow_();
  }

  /** The value that a control holds. @param {Control} control */
  valueIn_(control) {
    const key = keyOf(control);
    return key === 'light' ? this.lamps_.lamps : fieldValue(key, textIn(control));
  }

  /** @param {Control} control @param {string} shown */
  fill_(control, shown) {
    if (control instanceof HTMLSelectElement) offerVector(control, shown);
    if (keyOf(control) === 'light') this.lamps_.show(this.settings_.light ?? []);
    else if (isCheck(control)) control.checked = shown === 'true';
    else control.value = shown === 'NaN' ? '' : shown;
  }

  /** The change that a control asks for. @param {Control} control @returns {WorkSettings} */
  changeBy_(control) {
    const key = keyOf(control);
    if (key === 'light') return { light: this.lamps_.lamps };
    return fieldChange(key, textIn(control), this.settings_, this.placedMm_);
  }

  /** @param {import('../engine/types.js').Placement | undefined} placement  undefined: the code has no place */
  showPlaced(placement) {
    const isUpright = placement?.rotationDeg === this.settings_.rotateDeg; // else a code of that size may not fit
    this.placedMm_ = placement && isUpright ? Math.floor(100 * placement.symbolMm) / 100 : undefined;
  }

  /** Reports the edits of a control. A text is edited once typing pauses. @param {Control} control */
  watch_(control) {
    const isText = kSettings[keyOf(control)].kind === 'text';
    const apply = () => this.listener_?.onChange(this.changeBy_(control));
    const pause = new TypingPause(apply);
    control.addEventListener('input', () => {
      this.listener_?.onInput(this.changeBy_(control));
      if (isText) pause.typed();
    });
    control.addEventListener('change', () => void (isText ? pause.settle() : apply()));
  }

  nameAll_() {
    this.controls_.forEach(name);
    this.follow_();
  }

  /** Updates the label, the hint and the choice that depend on other controls. */
  follow_() {
    const { objective, light, albedo, patternMask } = this.settings_;
    this.pattern_.show(patternMask);
    this.filament_.show(albedo);
    byId('size-mm-label', HTMLElement).textContent = isSizeFixed(this.settings_)
      ? numberName('size')
      : controlName('maxSizeMm');
    byId('light-hint', HTMLElement).hidden = objective !== kOneLight || settingText(light) !== '';
  }
}

/** @param {Control} control @returns {control is HTMLInputElement & { type: 'checkbox' }} */
const isCheck = (control) => control instanceof HTMLInputElement && control.type === 'checkbox';

/** Returns a control's value as the text of a setting. @param {Control} control */
function textIn(control) {
  if (isCheck(control)) return String(control.checked);
  return control.validity.badInput ? 'NaN' : control.value;
}

/** @param {Control} control */
const keyOf = (control) => /** @type {FieldKey} */ (control.dataset.setting);

/**
 * Returns the choices that stand for a setting's numbers: every number of a short range, otherwise one word for all.
 * @param {FieldKey} key
 * @returns {string[]}
 */
function numbersOf(key) {
  const { whole, min = 0, max = Infinity } = kSettings[key];
  return whole && max - min < kMostListed
    ? Array.from({ length: max - min + 1 }, (_, at) => String(min + at))
    : [kFixed];
}

/** Returns the choices of a setting; '' is the choice of no value. @param {FieldKey} key @returns {readonly string[]} */
function choicesOf(key) {
  const { choices = [], kind } = kSettings[key];
  if (kind === 'vector') return ['', ...kAxes];
  if (key === 'pattern') return [...choices, kOwn];
  return kind === 'choice-or-number' ? [...choices, ...numbersOf(key)] : choices;
}

/** Returns the element of a control's hint. @param {Control} control */
const hintBelow = (control) => document.getElementById(`${control.id}-hint`);

/** Sets a control's choices and bounds, and makes room for its hint. @param {Control} control */
function prepare(control) {
  if (settingHint(keyOf(control))) {
    const hint = make('p', { className: 'field-hint' });
    hint.id = `${control.id}-hint`;
    control.after(hint);
    control.setAttribute('aria-describedby', hint.id);
  }
  const { kind, min, max } = kSettings[keyOf(control)];
  if (control instanceof HTMLSelectElement) {
    control.append(...choicesOf(keyOf(control)).map((value) => Object.assign(make('option'), { value })));
  } else if (kind === 'number') {
    Object.assign(control, { min: String(min), max: String(max) });
  }
}

/**
 * Adds a choice for a vector that is not listed, which takes the place of an earlier one.
 * @param {HTMLSelectElement} select
 * @param {string} value  any other value adds none
 */
function offerVector(select, value) {
  select.querySelector('.own')?.remove();
  const isListed = [...select.options].some((option) => option.value === value);
  if (isListed || !Array.isArray(settingFrom(keyOf(select), value))) return;
  select.append(Object.assign(make('option', { className: 'own' }), { value }));
  name(select);
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
  for (const option of control.options) option.textContent = optionName(key, option.value);
}

/** @param {FieldKey} key @param {string} value  of an option */
function optionName(key, value) {
  if (key === 'pattern' && value === kOwn) return controlLabel('patternMask');
  return value === kFixed ? choiceLabel(key, 'number') : valueName(key, fieldValue(key, value));
}
