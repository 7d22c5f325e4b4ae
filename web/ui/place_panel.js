// SPDX-License-Identifier: GPL-3.0-or-later
// The code's placement: its width and its exact centre.
import { text } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { byId } from '../dom/dom.js';
import { formatMm } from '../i18n/format.js';
import { showSpotCost } from './carve_panel.js';
import { showStep } from './steps.js';

/** @typedef {import('../engine/types.js').Placement} Placement */
/** @typedef {[number, number, number]} Point */

export class PlacePanel {
  constructor() {
    /** @type {(centreMm: Point) => void} */ this.onCentre_ = () => {};
    this.centre_ = ['centre-x', 'centre-y', 'centre-z'].map((id) => byId(id, HTMLInputElement));
    const place = () => {
      const centre = this.centre_.map((input) => input.valueAsNumber);
      if (centre.every(Number.isFinite)) this.onCentre_(/** @type {Point} */ (centre));
    };
    byId('place-here', HTMLButtonElement).addEventListener('click', place);
    for (const input of this.centre_) {
      input.addEventListener('keydown', (event) => {
        if (event.key !== 'Enter') return;
        event.preventDefault(); // otherwise Enter would engrave at the old place
        place();
      });
    }
    this.showPlacement(undefined);
  }

  /** @param {(centreMm: Point) => void} onCentre  called with a typed centre */
  listen(onCentre) {
    this.onCentre_ = onCentre;
  }

  /** @param {Point} centreMm */
  showCentre(centreMm) {
    this.centre_.forEach((input, axis) => {
      input.value = centreMm[axis].toFixed(2);
    });
  }

  /** @param {Placement | undefined} placement */
  showPlacement(placement) {
    const aim = byId('placement-aim', HTMLElement);
    aim.hidden = !placement;
    showSpotCost(placement?.colourLayers ?? 0);
    if (!placement) return showStep('place', 'open', () => text('page.placeNone'));
    const { symbolMm, guaranteedMm, aimToleranceDeg, forgiving } = placement;
    write(aim, () => text(!forgiving ? 'page.aimLittle' : 'page.aim', { deg: Math.floor(aimToleranceDeg) }));
    return showStep('place', 'done', () =>
      text('page.placeState', { width: formatMm(symbolMm), guaranteed: formatMm(guaranteedMm) }),
    );
  }
}
