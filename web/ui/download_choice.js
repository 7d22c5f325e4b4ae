// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of the file: its format, and the slicer that will open a file in two colours. Both are kept for the next
// visit.
import { text } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { byId } from '../dom/dom.js';
import { recall, remember } from '../storage/remembered.js';

/** @typedef {import('../engine/types.js').Mark} Mark */
/** @typedef {import('../engine/types.js').ModelInfo['only3mf']} Only3mf */
/** @typedef {{ format: string, slicer: import('../engine/types.js').Slicer }} Download  see `Engine::exportModel` */

/** The only format that holds two colours in one file. */
export const kTwoColours = '3mf-inlay';

/** The formats that hold a code with this mark, the best first; STL holds the model and its inlay in two files. */
const kFormats = { shadow: undefined, inlay: [kTwoColours, 'stl'], paint: [kTwoColours] };

/** @param {string} format */
const is3mf = (format) => format === '3mf' || format === kTwoColours;

export class DownloadChoice {
  constructor() {
    this.format_ = byId('format', HTMLSelectElement);
    this.slicer_ = byId('slicer', HTMLSelectElement);
    this.wanted_ = restored(this.format_); // for a code in one colour, of a model that every format holds
    restored(this.slicer_);
    /** @type {Mark} */ this.mark_ = 'shadow';
    /** @type {Only3mf} */ this.only3mf_ = [];
    /** The user's choices for the open model. @type {Partial<Record<Mark, string>>} */ this.picked_ = {};
    this.format_.addEventListener('change', () => {
      const { value } = this.format_;
      this.picked_[this.mark_] = value;
      if (this.mark_ === 'shadow') {
        this.wanted_ = value;
        remember(this.format_.id, value);
      }
      this.follow_();
    });
    this.slicer_.addEventListener('change', () => remember(this.slicer_.id, this.slicer_.value));
    this.follow_();
  }

  /**
   * Offers the formats that hold the code, and chooses one that keeps the contents of the model's file.
   * @param {Mark} mark
   * @param {Only3mf} only3mf  the same object for the same model
   */
  offerFor(mark, only3mf) {
    if (only3mf !== this.only3mf_) this.picked_ = {};
    this.mark_ = mark;
    this.only3mf_ = only3mf;
    const formats = kFormats[mark];
    for (const option of this.format_.options)
      option.hidden = option.disabled = formats !== undefined && !formats.includes(option.value);
    this.format_.value = this.picked_[mark] ?? formats?.[0] ?? this.best_();
    this.follow_();
  }

  /** Returns the best format for a code in one colour. */
  best_() {
    return this.only3mf_.length > 0 && !is3mf(this.wanted_) ? '3mf' : this.wanted_;
  }

  /** @returns {Download} */
  get chosen() {
    return { format: this.format_.value, slicer: /** @type {Download['slicer']} */ (this.slicer_.value) };
  }

  follow_() {
    byId('slicer-field', HTMLElement).hidden = this.format_.value !== kTwoColours;
    const why = byId('format-why', HTMLElement);
    const words = () => this.why_();
    why.hidden = words() === '';
    write(why, words);
  }

  /** Says why this format, or what it would lose. */
  why_() {
    if (this.mark_ === 'inlay' && this.format_.value === 'stl') return text('page.twoFiles');
    if (this.mark_ !== 'shadow') return text('page.onlyTwoColours');
    const [first, second] = this.only3mf_;
    if (!first) return '';
    return text(
      second ? 'page.only3mfKeepsBoth' : first === 'paint' ? 'page.only3mfKeepsPaint' : 'page.only3mfKeepsPlates',
    );
  }
}

/** Restores the last choice, also of the last visit. @param {HTMLSelectElement} chooser @returns {string} its value */
function restored(chooser) {
  const last = recall(chooser.id);
  if ([...chooser.options].some(({ value }) => value === last)) chooser.value = /** @type {string} */ (last);
  return chooser.value;
}
