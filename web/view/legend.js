// SPDX-License-Identifier: GPL-3.0-or-later
// The legend of the colours on the model, in mm.
import { text } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { byId } from '../dom/dom.js';

/** @typedef {'sizes' | 'depths'} LegendKind */

/** Digits behind the decimal point. @type {Record<LegendKind, number>} */
const kDigits = { sizes: 1, depths: 2 };

export class Legend {
  constructor() {
    this.figure_ = byId('legend', HTMLElement);
    this.title_ = byId('legend-title', HTMLElement);
    this.middle_ = byId('legend-middle', HTMLElement);
    this.top_ = byId('legend-top', HTMLElement);
    /** @type {LegendKind | undefined} */ this.kind_ = undefined;
  }

  /**
   * @param {LegendKind} kind
   * @param {number} topMm  value of the last colour
   * @param {boolean} [isExceeded]  some values with that colour are larger
   */
  show(kind, topMm, isExceeded = false) {
    this.kind_ = kind;
    write(this.title_, () => text(kind === 'sizes' ? 'view.sizesLegend' : 'view.depthsLegend'));
    write(this.middle_, () => text('view.millimetres', { mm: Number((topMm / 2).toFixed(kDigits[kind])) }));
    write(this.top_, () =>
      text(isExceeded ? 'view.millimetresOrMore' : 'view.millimetres', { mm: Number(topMm.toFixed(kDigits[kind])) }),
    );
    this.figure_.hidden = false;
  }

  /** @param {LegendKind} kind  the legend of another kind stays */
  hide(kind) {
    if (this.kind_ === kind) this.figure_.hidden = true;
  }
}
