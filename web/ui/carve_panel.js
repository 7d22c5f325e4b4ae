// SPDX-License-Identifier: GPL-3.0-or-later
// One line that sums up the carving to be made.
import { onLanguage, text } from '../i18n/catalogue.js';
import { choiceLabel } from '../i18n/setting_names.js';
import { byId } from '../dom/dom.js';
import { formatPlain } from '../i18n/format.js';
import { describeStep } from './steps.js';

export class CarvePanel {
  constructor() {
    this.preset_ = byId('preset', HTMLSelectElement);
    this.nozzle_ = byId('nozzle', HTMLInputElement);
    byId('step-carve', HTMLElement).addEventListener('change', () => this.show());
    onLanguage(() => this.show());
    this.show();
  }

  show() {
    const nozzle = this.nozzle_.valueAsNumber;
    describeStep('carve', () =>
      text('page.carveState', {
        preset: choiceLabel('preset', this.preset_.value).split(',')[0],
        nozzle: Number.isFinite(nozzle) ? formatPlain(nozzle) : '?',
      }),
    );
  }
}
