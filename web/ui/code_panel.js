// SPDX-License-Identifier: GPL-3.0-or-later
// What to engrave and how: the text and the settings.
import { byId } from './dom.js';
import { formatMm } from './format.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {import('../engine/types.js').Placement} Placement */
/** @typedef {[number, number, number]} Point */

const kTypingPauseMs = 250;

/**
 * @typedef {object} CodeListener
 * @property {() => void} onSettings
 * @property {(centreMm: Point) => void} onCentre
 */

export class CodePanel {
  /** @param {CodeListener} listener */
  constructor(listener) {
    this.text_ = byId('text', HTMLTextAreaElement);
    this.size_ = byId('size', HTMLSelectElement);
    this.sizeMm_ = byId('size-mm', HTMLInputElement);
    this.sizeMmLabel_ = byId('size-mm-label', HTMLElement);
    this.facts_ = byId('placement-facts', HTMLElement);
    this.centre_ = ['centre-x', 'centre-y', 'centre-z'].map((id) => byId(id, HTMLInputElement));
    const settings = byId('settings', HTMLDetailsElement);

    /** @type {ReturnType<typeof setTimeout> | undefined} */ let pause;
    this.text_.addEventListener('input', () => {
      clearTimeout(pause);
      pause = setTimeout(listener.onSettings, kTypingPauseMs);
    });
    settings.addEventListener('change', (event) => {
      if (this.centre_.some((input) => input === event.target)) return;  // three numbers make one point
      this.nameSizeField_();
      listener.onSettings();
    });
    byId('place-here', HTMLButtonElement).addEventListener('click', () => {
      const centre = this.centre_.map((input) => input.valueAsNumber);
      if (centre.every(Number.isFinite)) listener.onCentre(/** @type {Point} */ (centre));
    });
  }

  get text() {
    return this.text_.value;
  }

  set text(value) {
    this.text_.value = value;
  }

  /**
   * @returns {Settings}
   * @throws {RangeError} in words, if a number is missing or out of range
   */
  settings() {
    const fixed = this.size_.value === 'fixed';
    const sizeMm = requiredNumber('size-mm');
    const maxDepthMm = optionalNumber('max-depth');
    const contrast = optionalNumber('contrast');
    return /** @type {Settings} */ ({
      text: this.text_.value,
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

  /** @param {Point} centreMm */
  showCentre(centreMm) {
    this.centre_.forEach((input, axis) => {
      input.value = centreMm[axis].toFixed(2);
    });
  }

  /** @param {Placement} placement */
  showPlacement({ version, modules, symbolMm, moduleMm, guaranteedMm }) {
    this.facts_.textContent = `${formatMm(symbolMm)} wide, modules of ${formatMm(moduleMm)} · version ${version}, ` +
      `${modules}\u00a0×\u00a0${modules} · up to ${formatMm(guaranteedMm)} fits here`;
  }

  hidePlacement() {
    this.facts_.textContent = '';
  }

  nameSizeField_() {
    this.sizeMmLabel_.textContent = this.size_.value === 'fixed' ? 'Width (mm)' : 'At most (mm)';
  }
}

/** @param {string} id */
const choice = (id) => byId(id, HTMLSelectElement).value;

/** @param {string} id @returns {number | undefined} */
function optionalNumber(id) {
  const input = byId(id, HTMLInputElement);
  const label = input.labels?.[0]?.textContent ?? id;
  if (!input.validity.valid) {
    const range = `from ${input.min} to ${input.max}`;
    throw new RangeError(`“${label}” must be a number ${range}${input.value ? `, not ${input.value}` : ''}`);
  }
  return input.value === '' ? undefined : input.valueAsNumber;
}

/** @param {string} id */
const requiredNumber = (id) => /** @type {number} */ (optionalNumber(id));
