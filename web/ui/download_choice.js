// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of the file: its format, and the slicer that will open a file in two colours. Both are kept for the next
// visit.
import { byId } from '../dom/dom.js';
import { recall, remember } from '../storage/remembered.js';

/** @typedef {import('../engine/types.js').Mark} Mark */
/** @typedef {{ format: string, slicer: import('../engine/types.js').Slicer }} Download  see `Engine::exportModel` */

/** The only format that holds two colours. */
export const kTwoColours = '3mf-inlay';

export class DownloadChoice {
  constructor() {
    this.format_ = byId('format', HTMLSelectElement);
    this.slicer_ = byId('slicer', HTMLSelectElement);
    this.wanted_ = restored(this.format_); // for a code in one colour
    restored(this.slicer_);
    this.inColour_ = false;
    this.format_.addEventListener('change', () => {
      this.wanted_ = this.format_.value;
      remember(this.format_.id, this.wanted_);
      this.follow_();
    });
    this.slicer_.addEventListener('change', () => remember(this.slicer_.id, this.slicer_.value));
    this.follow_();
  }

  /** Offers the formats that hold the code. @param {Mark} mark */
  offerFor(mark) {
    this.inColour_ = mark !== 'shadow';
    for (const option of this.format_.options)
      option.hidden = option.disabled = this.inColour_ && option.value !== kTwoColours;
    this.format_.value = this.inColour_ ? kTwoColours : this.wanted_;
    this.follow_();
  }

  /** @returns {Download} */
  get chosen() {
    return { format: this.format_.value, slicer: /** @type {Download['slicer']} */ (this.slicer_.value) };
  }

  follow_() {
    byId('slicer-field', HTMLElement).hidden = this.format_.value !== kTwoColours;
    byId('format-why', HTMLElement).hidden = !this.inColour_;
  }
}

/** Restores the last choice, also of the last visit. @param {HTMLSelectElement} chooser @returns {string} its value */
function restored(chooser) {
  const last = recall(chooser.id);
  if ([...chooser.options].some(({ value }) => value === last)) chooser.value = /** @type {string} */ (last);
  return chooser.value;
}
