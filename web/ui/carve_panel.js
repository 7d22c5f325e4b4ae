// SPDX-License-Identifier: GPL-3.0-or-later
// What will be carved, in one line.
import { onLanguage, text } from '../i18n/catalogue.js';
import { byId } from '../dom/dom.js';
import { formatPlain } from '../i18n/format.js';
import { describeStep } from './steps.js';

const kPresets = /** @type {const} */ ({ shallow: 'settings.presetShallow', balanced: 'settings.presetBalanced', robust: 'settings.presetRobust' });

export class CarvePanel {
  constructor() {
    this.preset_ = byId('preset', HTMLSelectElement);
    this.nozzle_ = byId('nozzle', HTMLInputElement);
    byId('step-carve', HTMLElement).addEventListener('change', () => this.show());
    onLanguage(() => this.show());
    this.show();
  }

  show() {
    const preset = kPresets[/** @type {keyof typeof kPresets} */ (this.preset_.value)];
    const nozzle = this.nozzle_.valueAsNumber;
    describeStep('carve', () => text('page.carveState',
      { preset: text(preset).split(',')[0], nozzle: Number.isFinite(nozzle) ? formatPlain(nozzle) : '?' }));
  }
}
