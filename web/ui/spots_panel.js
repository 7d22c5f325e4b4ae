// SPDX-License-Identifier: GPL-3.0-or-later
// Where a code could go: suggestions to choose from, and the sizes as colours on the model.
import { byId, make } from './dom.js';

/** @typedef {import('../engine/types.js').Spots} Spots */

/**
 * @typedef {object} SpotsListener
 * @property {() => void} onSuggest
 * @property {(index: number) => void} onSpot
 * @property {(shown: boolean) => void} onSizes
 */

export class SpotsPanel {
  /** @param {SpotsListener} listener */
  constructor({ onSuggest, onSpot, onSizes }) {
    this.suggest_ = byId('suggest', HTMLButtonElement);
    this.list_ = byId('spots', HTMLUListElement);
    this.sizes_ = byId('show-sizes', HTMLButtonElement);
    this.legend_ = byId('legend', HTMLElement);
    this.onSpot_ = onSpot;
    this.suggest_.addEventListener('click', onSuggest);
    this.sizes_.addEventListener('click', () => {
      const shown = this.sizes_.getAttribute('aria-pressed') !== 'true';
      this.setSizesShown(shown);
      onSizes(shown);
    });
  }

  /** @param {boolean} allowed */
  allow(allowed) {
    this.suggest_.disabled = !allowed;
  }

  /** @param {Spots} found */
  show({ spots, topMm }) {
    this.list_.replaceChildren(...spots.map(({ sizeMm }, index) => {
      const button = make('button', { text: `Spot ${index + 1}` },
        make('span', { text: `up to ${wholeMm(sizeMm)} mm` }));
      button.type = 'button';
      button.setAttribute('aria-pressed', 'false');
      button.addEventListener('click', () => this.onSpot_(index));
      return make('li', {}, button);
    }));
    byId('legend-top', HTMLElement).textContent = `${topMm} mm`;
    this.sizes_.disabled = false;
    this.setSizesShown(true);
    this.list_.scrollIntoView({ block: 'nearest' });
  }

  clear() {
    this.list_.replaceChildren();
    this.sizes_.disabled = true;
    this.setSizesShown(false);
  }

  /** @param {number} [index]  none: the centre is somewhere else */
  mark(index) {
    [...this.list_.querySelectorAll('button')].forEach((button, i) => button.setAttribute('aria-pressed', String(i === index)));
  }

  get known() {
    return this.list_.childElementCount > 0;
  }

  /** @param {boolean} shown */
  setSizesShown(shown) {
    this.sizes_.setAttribute('aria-pressed', String(shown));
    this.legend_.hidden = !shown;
  }
}

/** Rounded down: so much does fit. @param {number} mm */
const wholeMm = (mm) => (mm < 10 ? Math.floor(mm * 10) / 10 : Math.floor(mm));
