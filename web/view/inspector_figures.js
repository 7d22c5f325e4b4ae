// SPDX-License-Identifier: GPL-3.0-or-later
// The texts and numbers of the inspector as a table, for screen readers and for copying: its window is pixels.
import { byId, make } from '../dom/dom.js';

export class InspectorFigures {
  constructor() {
    this.details_ = byId('inspector-figures', HTMLDetailsElement);
    this.rows_ = byId('inspector-rows', HTMLElement);
    /** @type {string[][] | undefined} */ this.figures_ = undefined;
    this.drawn_ = '';
    this.details_.addEventListener('toggle', () => this.draw_());
  }

  /** @param {string[][] | undefined} figures  undefined: the inspector is closed */
  show(figures) {
    this.details_.hidden = figures === undefined;
    this.figures_ = figures;
    this.draw_();
  }

  /** Writes the table if it is seen and has changed: otherwise a selection in it would be lost at every frame. */
  draw_() {
    const { figures_: figures = [] } = this;
    const now = JSON.stringify(figures);
    if (!this.details_.open || now === this.drawn_) return;
    this.drawn_ = now;
    const most = Math.max(1, ...figures.map(({ length }) => length));
    this.rows_.replaceChildren(...figures.map((cells) => make('tr', {}, ...cellsOf(cells, most))));
  }
}

/** @param {string[]} cells @param {number} most  cells of the longest row */
function cellsOf([first, ...values], most) {
  if (values.length === 0) return [Object.assign(make('td', { text: first }), { colSpan: most })];
  const head = Object.assign(make('th', { text: first }), { scope: 'row' });
  return [head, ...values.map((value) => make('td', { text: value }))];
}
