// SPDX-License-Identifier: GPL-3.0-or-later
// Every control that carries `data-setting`: what it says, and what the module is to do with it.
import { EngineFailure } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { onLanguage } from '../i18n/catalogue.js';
import { controlName } from '../i18n/setting_names.js';
import { byId } from '../dom/dom.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {HTMLInputElement | HTMLSelectElement} Control */
/** @typedef {import('../storage/last_work.js').Values} Values */

/** @type {Record<string, string>}  the core's, by the controls' ids */
const kKeys = {
  rotate: 'rotateDeg', 'min-wall': 'minWallMm', nozzle: 'nozzleMm', layer: 'layerMm', 'eye-distance': 'eyeDistanceMm',
  contrast: 'contrast', 'max-depth': 'maxDepthMm',
};

export class SettingsForm {
  /** @param {(id: string) => void} onChange  the control that was changed */
  constructor(onChange) {
    this.onChange_ = onChange;
    this.controls_ = /** @type {Control[]} */ ([...document.querySelectorAll('[data-setting]')]);
    for (const control of this.controls_) {
      control.addEventListener('change', () => {
        this.nameSizeField_();
        onChange(control.id);
      });
    }
    onLanguage(() => this.nameSizeField_());
    this.nameSizeField_();
    this.defaults = this.values;
  }

  /** @returns {Values} */
  get values() {
    return Object.fromEntries(this.controls_.map((control) => [control.id, isCheck(control) ? control.checked : control.value]));
  }

  set values(values) {
    for (const control of this.controls_) {
      const value = values[control.id];
      if (value === undefined) continue;
      if (isCheck(control)) control.checked = Boolean(value);
      else control.value = String(value);
    }
    this.nameSizeField_();
  }

  /** As if the user had typed them, at once. @param {Values} values */
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
    const fixed = choice('size') === 'fixed';
    const sizeMm = requiredNumber('size-mm');
    const maxDepthMm = optionalNumber('max-depth');
    const contrast = optionalNumber('contrast');
    return /** @type {Settings} */ ({
      text: content,
      preset: choice('preset'),
      pattern: choice('pattern'),
      finderPattern: choice('finder-pattern'),
      size: fixed ? sizeMm : choice('size'),
      maxSizeMm: sizeMm,
      quietZone: byId('quiet-zone', HTMLInputElement).checked,
      direction: choice('direction'),
      rotateDeg: requiredNumber('rotate'),
      minWallMm: requiredNumber('min-wall'),
      nozzleMm: requiredNumber('nozzle'),
      layerMm: requiredNumber('layer'),
      eyeDistanceMm: requiredNumber('eye-distance'),
      ...(choice('ecc') === 'auto' ? {} : { ecc: choice('ecc') }),
      ...(contrast === undefined ? {} : { contrast }),
      ...(maxDepthMm === undefined ? {} : { maxDepthMm }),
    });
  }

  nameSizeField_() {
    byId('size-mm-label', HTMLElement).textContent = controlName(sizeKey());
  }
}

/** @param {Control} control @returns {control is HTMLInputElement} */
const isCheck = (control) => control instanceof HTMLInputElement && control.type === 'checkbox';

/** @param {string} id */
const choice = (id) => byId(id, HTMLSelectElement).value;

/** @param {string} id @returns {number | undefined} */
function optionalNumber(id) {
  const input = byId(id, HTMLInputElement);
  if (!input.validity.valid) throw new EngineFailure({ kind: 'BadUsage', ...whyInvalid(input) });
  return input.value === '' ? undefined : input.valueAsNumber;
}

/** @param {HTMLInputElement} input */
function whyInvalid({ id, min, max, value }) {
  const setting = { setting: id === 'size-mm' ? sizeKey() : kKeys[id] };
  const from = { number: Number(min) };
  const to = { number: Number(max) };
  return value === '' ? message('control-not-a-number', { setting, from, to })
    : message('control-out-of-range', { setting, from, to, value: { number: Number(value) } });
}

const sizeKey = () => (choice('size') === 'fixed' ? 'sizeMm' : 'maxSizeMm');

/** @param {string} id */
const requiredNumber = (id) => /** @type {number} */ (optionalNumber(id));
