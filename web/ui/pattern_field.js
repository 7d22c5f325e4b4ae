// SPDX-License-Identifier: GPL-3.0-or-later
// The grid in which a pattern of one's own is drawn: a button for each submodule. One of them is in the tab order; arrow
// keys lead to the others. The setting's own control, a hidden field, announces the changes.
import { byId, make } from '../dom/dom.js';
import { onLanguage, text } from '../i18n/catalogue.js';
import { controlLabel } from '../i18n/setting_names.js';

const kEdge = 5; // submodules
const kSteps = /** @type {Record<string, [number, number]>} */ ({
  ArrowUp: [-1, 0],
  ArrowDown: [1, 0],
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
});

export class PatternField {
  constructor() {
    this.value_ = byId('pattern-mask', HTMLInputElement);
    this.grid_ = byId('pattern-grid', HTMLElement);
    this.cells_ = Array.from({ length: kEdge * kEdge }, (_, at) => this.cell_(at));
    this.grid_.append(...this.cells_);
    this.focusable_(0);
    onLanguage(() => this.name_());
    this.name_();
  }

  /** Shows the grid with this mask, or hides it. @param {string} [mask] */
  show(mask) {
    byId('own-pattern', HTMLElement).hidden = !mask;
    const carved = (mask ?? '').replaceAll('/', '');
    this.cells_.forEach((cell, at) => cell.setAttribute('aria-pressed', String(carved[at] === '1')));
  }

  /** @param {number} at */
  cell_(at) {
    const cell = Object.assign(make('button'), { type: 'button' });
    cell.addEventListener('click', () => {
      cell.setAttribute('aria-pressed', String(!isCarved(cell)));
      this.focusable_(at);
      this.value_.value = this.mask_();
      this.value_.dispatchEvent(new Event('change', { bubbles: true }));
    });
    cell.addEventListener('keydown', (event) => {
      const step = kSteps[event.key];
      if (!step) return;
      event.preventDefault();
      const [row, column] = [Math.floor(at / kEdge) + step[0], (at % kEdge) + step[1]];
      if (Math.min(row, column) < 0 || Math.max(row, column) >= kEdge) return;
      this.focusable_(row * kEdge + column);
      this.cells_[row * kEdge + column].focus();
    });
    return cell;
  }

  mask_() {
    const carved = this.cells_.map((cell) => (isCarved(cell) ? '1' : '0')).join('');
    return Array.from({ length: kEdge }, (_, row) => carved.slice(row * kEdge, (row + 1) * kEdge)).join('/');
  }

  /** Puts one cell in the tab order. @param {number} at */
  focusable_(at) {
    this.cells_.forEach((cell, other) => {
      cell.tabIndex = other === at ? 0 : -1;
    });
  }

  name_() {
    this.grid_.setAttribute('aria-label', controlLabel('patternMask'));
    this.cells_.forEach((cell, at) => {
      const [row, column] = [Math.floor(at / kEdge) + 1, (at % kEdge) + 1];
      cell.setAttribute('aria-label', text('settings.patternCell', { row, column }));
    });
  }
}

/** @param {HTMLButtonElement} cell */
const isCarved = (cell) => cell.getAttribute('aria-pressed') === 'true';
