// SPDX-License-Identifier: GPL-3.0-or-later
// The label next to the pointer or the handle that shows how large the code would be there.
import { make } from '../dom/dom.js';
import { text } from '../i18n/catalogue.js';
import { sentenceOf } from '../i18n/messages.js';

/** @typedef {import('../engine/types.js').CodeFacts} CodeFacts */

const kOffsetPx = 20;
const kLeastModuleMm = 0.2; // the engine refuses smaller modules (core/projection/size_bound.h)

export class CodeChip {
  /** @param {HTMLElement} overlay  covers the canvas */
  constructor(overlay) {
    this.overlay_ = overlay;
    this.size_ = make('strong');
    this.module_ = make('span');
    this.warning_ = make('span', { className: 'warning' });
    this.depths_ = make('span');
    this.element_ = make('div', { className: 'code-chip' }, this.size_, this.module_, this.depths_, this.warning_);
    this.element_.hidden = true;
    this.element_.setAttribute('aria-hidden', 'true'); // the panel announces the size, but not for every pixel
    overlay.append(this.element_);
    /** The pointer or handle. @type {[number, number]} */ this.at_ = [0, 0];
  }

  /** @param {CodeFacts} facts @param {number} x @param {number} y  position of the pointer or handle */
  show({ symbolMm, moduleMm, capitalMm, missingShare, forgiving, exact }, x, y) {
    const isPossible = moduleMm >= kLeastModuleMm;
    this.size_.textContent = isPossible
      ? text(exact ? 'view.chipSize' : 'view.chipAbout', { mm: millimetres(symbolMm) })
      : '';
    const detail =
      capitalMm === null
        ? text('view.chipModules', { mm: millimetres(moduleMm, 2) })
        : text('view.chipCapitals', { mm: millimetres(capitalMm) });
    this.module_.textContent = isPossible ? detail : '';
    this.depths_.textContent = '';
    const missing = Math.max(1, Math.round(missingShare * 100));
    this.warning_.textContent = !isPossible
      ? text('view.chipTooSmall')
      : missingShare > 0
        ? text('view.chipMissing', { percent: missing })
        : forgiving
          ? ''
          : text('view.chipBent');
    this.element_.dataset.exact = String(exact);
    this.place_(x, y);
  }

  /** Adds the first reason why the code may not print or decode, unless a worse one is shown. @param {import('../engine/types.js').Message[]} concerns */
  showConcerns([first]) {
    if (!first || this.warning_.textContent) return;
    this.warning_.textContent = sentenceOf(first);
    this.placeAgain_();
  }

  /** Adds about how deep the code will be on average. @param {import('../engine/types.js').FoundDepths} depths */
  showDepthAbout({ meanMm }) {
    this.depths_.textContent = text('view.chipDepthAbout', { mean: millimetres(meanMm) });
    this.placeAgain_();
  }

  /** Adds how deep the code will be. @param {import('../engine/types.js').FoundDepths} depths */
  showDepths({ meanMm, maxMm }) {
    const depths = { mean: millimetres(meanMm, 2), deepest: millimetres(maxMm, 2) };
    this.depths_.textContent = text('view.chipDepths', depths);
    this.placeAgain_();
  }

  /** @param {number} x @param {number} y */
  showNoRoom(x, y) {
    this.size_.textContent = '';
    this.module_.textContent = '';
    this.depths_.textContent = '';
    this.warning_.textContent = text('view.chipNoRoom');
    this.place_(x, y);
  }

  hide() {
    this.element_.hidden = true;
  }

  /** Puts the label next to the point, on the side that has room. @param {number} x @param {number} y */
  place_(x, y) {
    this.at_ = [x, y];
    this.element_.hidden = false;
    this.placeAgain_();
  }

  /** Finds the side that has room again: more lines make the label larger. */
  placeAgain_() {
    const [x, y] = this.at_;
    const { offsetWidth, offsetHeight } = this.element_;
    const { clientWidth, clientHeight } = this.overlay_;
    const left = x + kOffsetPx + offsetWidth <= clientWidth ? x + kOffsetPx : x - kOffsetPx - offsetWidth;
    const top = y + kOffsetPx + offsetHeight <= clientHeight ? y + kOffsetPx : y - kOffsetPx - offsetHeight;
    this.element_.style.transform = `translate(${Math.max(0, Math.round(left))}px, ${Math.max(0, Math.round(top))}px)`;
  }
}

/** @param {number} mm @param {number} [digits] */
const millimetres = (mm, digits = 1) => Number(mm.toFixed(digits));
