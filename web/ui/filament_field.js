// SPDX-License-Identifier: GPL-3.0-or-later
// The model's colour by name, beside the number of its albedo. A choice fills in the number, or clears it for the default
// of the mark; the number's own control announces the change.
import { byId, make } from '../dom/dom.js';
import { onLanguage, text } from '../i18n/catalogue.js';
import { settingText } from '../settings/setting_text.js';

/**
 * Colours by the fraction of visible light that they reflect. White and cream are estimates, and the core's
 * defaults for a code in colour and for a shadow. The others are patches of the ColorChecker chart, rounded: by
 * their published lightness L*, ((L* + 16) / 116)³ is 0.59 for neutral 8 (81.3), 0.60 for yellow (81.8) and 0.36 for
 * neutral 6.5 (66.9). Darker colours are left out, because they leave a shadow too little contrast.
 */
export const kFilaments = /** @type {const} */ ([
  { name: 'settings.filamentAuto', albedo: undefined },
  { name: 'settings.filamentWhite', albedo: 0.85 },
  { name: 'settings.filamentCream', albedo: 0.7 },
  { name: 'settings.filamentLight', albedo: 0.6 },
  { name: 'settings.filamentGrey', albedo: 0.35 },
]);

export class FilamentField {
  constructor() {
    this.choice_ = byId('filament', HTMLSelectElement);
    this.albedo_ = byId('albedo', HTMLInputElement);
    this.choice_.append(
      ...kFilaments.map(({ albedo }) => Object.assign(make('option'), { value: settingText(albedo) })),
    );
    this.choice_.addEventListener('change', () => {
      this.albedo_.value = this.choice_.value;
      this.albedo_.dispatchEvent(new Event('change', { bubbles: true }));
    });
    onLanguage(() => this.name_());
    this.name_();
  }

  /** Selects the colour with this albedo, or adds a choice for any other. @param {number} [albedo]  none: the default */
  show(albedo) {
    const value = settingText(albedo);
    this.choice_.querySelector('.own')?.remove();
    if (!kFilaments.some((filament) => filament.albedo === albedo)) {
      this.choice_.append(Object.assign(make('option', { className: 'own' }), { value }));
      this.name_();
    }
    this.choice_.value = value;
  }

  name_() {
    [...this.choice_.options].forEach((option, at) => {
      option.textContent = text(kFilaments[at]?.name ?? 'settings.filamentOther');
    });
  }
}
