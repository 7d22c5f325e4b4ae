// SPDX-License-Identifier: GPL-3.0-or-later
// The editor of the lamps that a code is carved for: their number and, for each, direction, elevation and strength. The
// setting's own control, a hidden field, announces the changes.
import { byId, make } from '../dom/dom.js';
import { kSettings } from '../generated/settings.js';
import { onLanguage, text } from '../i18n/catalogue.js';

/** @typedef {import('../engine/lamps.js').Lamp} Lamp */

const { parts: kRanges = {}, most: kMostLamps = 0 } = kSettings.light;
const kParts = /** @type {const} */ (['azimuthDeg', 'elevationDeg', 'strength']);
const kDefaults = /** @type {Required<Lamp>} */ (
  Object.fromEntries(kParts.map((part) => [part, kRanges[part].default]))
);
/** The initial lamps: the first above the code, the second to its left. @type {readonly Required<Lamp>[]} */
const kFirst = Array.from({ length: kMostLamps }, (_, at) => ({
  ...kDefaults,
  azimuthDeg: 90 * (at + 1),
  elevationDeg: 40,
}));

export class LampsField {
  constructor() {
    this.value_ = byId('light', HTMLInputElement);
    this.count_ = byId('lamp-count', HTMLSelectElement);
    this.count_.append(
      ...Array.from({ length: kMostLamps + 1 }, (_, lamps) => Object.assign(make('option'), { value: String(lamps) })),
    );
    this.lamps_ = kFirst.map((first, at) => this.fieldsOf_(first, at));
    byId('lamps', HTMLElement).append(...this.lamps_.map(({ box }) => box));
    this.count_.addEventListener('change', () => this.announce_());
    onLanguage(() => this.name_());
    this.name_();
    this.show([]);
  }

  /** The lamps in the fields; NaN where a number is missing. @returns {Lamp[] | undefined}  undefined: none */
  get lamps() {
    const used = this.lamps_.slice(0, Number(this.count_.value));
    if (used.length === 0) return undefined;
    return used.map(
      ({ inputs }) =>
        /** @type {Lamp} */ (Object.fromEntries(kParts.map((part) => [part, inputs[part].valueAsNumber]))),
    );
  }

  /** @param {readonly Lamp[]} lamps */
  show(lamps) {
    this.count_.value = String(Math.min(lamps.length, kMostLamps));
    this.lamps_.forEach(({ inputs }, at) =>
      kParts.forEach((part) => {
        inputs[part].valueAsNumber = (lamps[at] ? { ...kDefaults, ...lamps[at] } : kFirst[at])[part]; // NaN empties it
      }),
    );
    this.showUsed_();
  }

  /** @param {Required<Lamp>} first @param {number} at */
  fieldsOf_(first, at) {
    const inputs = /** @type {Record<keyof Lamp, HTMLInputElement>} */ ({});
    const labels = /** @type {Record<keyof Lamp, HTMLElement>} */ ({});
    const fields = kParts.map((part) => {
      const id = `lamp-${at + 1}-${part}`;
      const { min, max } = kRanges[part];
      inputs[part] = Object.assign(make('input'), {
        id,
        type: 'number',
        min: String(min),
        max: String(max),
        step: 'any',
        value: String(first[part]),
        required: true,
      });
      labels[part] = Object.assign(make('label'), { htmlFor: id });
      inputs[part].addEventListener('change', () => this.announce_());
      return make('div', { className: 'field' }, labels[part], inputs[part]);
    });
    const legend = make('legend');
    const box = make('fieldset', { className: 'lamp' }, legend, make('div', { className: 'row' }, ...fields));
    return { box, legend, inputs, labels };
  }

  name_() {
    [...this.count_.options].forEach((option, lamps) => {
      option.textContent = text(
        /** @type {const} */ (['settings.evenLight', 'settings.oneLamp', 'settings.twoLamps'])[lamps],
      );
    });
    this.lamps_.forEach(({ legend, labels }, at) => {
      legend.textContent = text('settings.lampNumber', { number: at + 1 });
      labels.azimuthDeg.textContent = text('settings.lampDirection');
      labels.elevationDeg.textContent = text('settings.lampElevation');
      labels.strength.textContent = text('settings.lampStrength');
    });
  }

  announce_() {
    this.showUsed_();
    this.value_.dispatchEvent(new Event('change', { bubbles: true }));
  }

  showUsed_() {
    this.lamps_.forEach(({ box }, at) => {
      box.hidden = at >= Number(this.count_.value);
    });
  }
}
