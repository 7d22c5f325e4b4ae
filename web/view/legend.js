// SPDX-License-Identifier: GPL-3.0-or-later
// The legend of the colours on the model: a scale in mm, or two colours.
import { text } from '../i18n/catalogue.js';
import { formatPlain } from '../i18n/format.js';
import { write } from '../i18n/live.js';
import { byId } from '../dom/dom.js';

/** @typedef {'sizes' | 'depths'} LegendKind */

/** Digits behind the decimal point. @type {Record<LegendKind, number>} */
const kDigits = { sizes: 1, depths: 2 };

export class Legend {
  constructor() {
    this.figure_ = byId('legend', HTMLElement);
    this.zero_ = byId('legend-zero', HTMLElement);
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
    this.figure_.classList.remove('two');
    write(this.zero_, () => text('view.legendZero'));
    write(this.title_, () => text(kind === 'sizes' ? 'view.sizesLegend' : 'view.depthsLegend'));
    write(this.middle_, () => text('view.millimetres', { mm: Number((topMm / 2).toFixed(kDigits[kind])) }));
    write(this.top_, () =>
      text(isExceeded ? 'view.millimetresOrMore' : 'view.millimetres', { mm: Number(topMm.toFixed(kDigits[kind])) }),
    );
    this.figure_.hidden = false;
  }

  /** Says which colour has room for a code of a fixed size. @param {number} fixedMm */
  showRoom(fixedMm) {
    this.kind_ = 'sizes';
    this.figure_.classList.add('two');
    write(this.title_, () => text('view.roomLegend', { mm: formatPlain(fixedMm, kDigits.sizes) }));
    write(this.zero_, () => text('view.noRoom'));
    write(this.middle_, () => '');
    write(this.top_, () => text('view.room'));
    this.figure_.hidden = false;
  }

  /** @param {LegendKind} kind  the legend of another kind stays */
  hide(kind) {
    if (this.kind_ === kind) this.figure_.hidden = true;
  }
}
