// SPDX-License-Identifier: GPL-3.0-or-later
// Every control that carries `data-setting`: what it says, and what the module is to do with it.
import { currentLanguage, onLanguage, text } from '../i18n/catalogue.js';
import { byId } from './dom.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {HTMLInputElement | HTMLSelectElement} Control */
/** @typedef {Record<string, string | boolean>} Values  what the controls hold, by their ids */

/** A setting that cannot be used, in words that follow the language. */
export class SettingProblem extends RangeError {
  /** @param {import('../i18n/live.js').Words} words */
  constructor(words) {
    super(words());
    this.words = words;
  }
}

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
   * @throws {SettingProblem} if a number is missing or out of range
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
    byId('size-mm-label', HTMLElement).textContent = text(choice('size') === 'fixed' ? 'settings.widthMm' : 'settings.atMostMm');
  }
}

/** @param {Control} control @returns {control is HTMLInputElement} */
const isCheck = (control) => control instanceof HTMLInputElement && control.type === 'checkbox';

/** @param {string} id */
const choice = (id) => byId(id, HTMLSelectElement).value;

/** @param {string} id @returns {number | undefined} */
function optionalNumber(id) {
  const input = byId(id, HTMLInputElement);
  if (!input.validity.valid) {
    const { min, max, value } = input;
    throw new SettingProblem(() => {
      const label = input.labels?.[0]?.textContent ?? id;
      return value ? text('settings.outOfRange', { label, min: written(min), max: written(max), value: written(value) })
        : text('settings.missing', { label, min: written(min), max: written(max) });
    });
  }
  return input.value === '' ? undefined : input.valueAsNumber;
}

/** As it is typed, with the language's decimal mark. @param {string} number */
const written = (number) => Number(number).toLocaleString(currentLanguage(), { useGrouping: false, maximumFractionDigits: 6 });

/** @param {string} id */
const requiredNumber = (id) => /** @type {number} */ (optionalNumber(id));
