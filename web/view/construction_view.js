// SPDX-License-Identifier: GPL-3.0-or-later
// How the code was placed: the names of the points of the construction that the module draws, and its legend.
import { text } from '../i18n/catalogue.js';
import { formatNumber } from '../i18n/format.js';
import { write } from '../i18n/live.js';
import { byId, make } from '../dom/dom.js';

/** @typedef {import('../engine/types.js').Construction} Construction */
/** @typedef {import('../engine/types.js').PointOnScreen} PointOnScreen */
/** @typedef {'plane' | 'projection' | 'silhouette' | 'closest' | 'square' | 'directions'} Part */

/** @type {Part[]} */
const kParts = ['plane', 'projection', 'silhouette', 'closest', 'square', 'directions'];
const kMostSteps = 6; // directions that the legend lists, and arrows with a number
const kNearPx = 18; // names nearer to each other than this would overlap

export class ConstructionView {
  constructor() {
    this.names_ = make('div', { className: 'construction-names' });
    this.names_.setAttribute('aria-hidden', 'true'); // the legend gives the same information
    byId('view', HTMLElement).querySelector('.code-overlay')?.append(this.names_);
    this.rows_ = new Map(kParts.map((part) => [part, make('li', { className: part })]));
    const title = make('summary');
    write(title, () => text('view.constructionLegend'));
    this.legend_ = make('details', { className: 'construction-legend' }, title, make('ul', {}, ...this.rows_.values()));
    this.legend_.hidden = true;
    this.legend_.open = !matchMedia('(max-width: 760px), (max-height: 500px)').matches; // it would cover the construction
    byId('view-overlays', HTMLElement).append(this.legend_);
    /** @type {Construction | null} */ this.construction_ = null;
  }

  /** @param {Construction | null} construction */
  explain(construction) {
    this.construction_ = construction;
    this.legend_.hidden = !construction;
    if (!construction) return;
    const { eyeMm, closestMm, largestMm, squareMm, variancesMm2, colours } = construction;
    const swatches = { ...colours, closest: colours.silhouette };
    for (const part of kParts) this.rows_.get(part)?.style.setProperty('--swatch', swatches[part]);
    const say = (/** @type {Part} */ part, /** @type {() => string} */ words) =>
      write(/** @type {HTMLElement} */ (this.rows_.get(part)), words);
    say('plane', () => text('view.constructionPlane'));
    say('projection', () => text('view.constructionEye', { mm: Math.round(eyeMm) }));
    say('silhouette', () => text('view.constructionSilhouette'));
    say('closest', () =>
      closestMm === null ? text('view.constructionFar') : text('view.constructionClosest', { mm: rounded(closestMm) }),
    );
    say('square', () => text('view.constructionSquare', { squareMm: rounded(squareMm), codeMm: rounded(largestMm) }));
    say('directions', () => text('view.constructionDirections', { steps: stepsOf(construction) }));
    /** @type {HTMLElement} */ (this.rows_.get('directions')).hidden = variancesMm2.length === 0;
  }

  /** Shows the names of the points. @param {import('../engine/types.js').ConstructionOnScreen | null} points */
  mark(points) {
    if (!points) {
      this.names_.replaceChildren();
      return;
    }
    /** @type {[string, string, PointOnScreen][]} */
    const named = [
      ['C', 'plane', points.centre],
      ['S', 'closest', points.closest],
      [text('view.constructionEyeName'), 'projection', points.eye],
      ...numbered(points.directions, this.construction_?.chosen ?? null),
    ];
    this.names_.replaceChildren(
      ...named.flatMap(([words, className, at]) => {
        if (!at) return [];
        const name = make('span', { className, text: words });
        name.style.transform = `translate(${at[0] + 7}px, ${at[1] - 20}px)`;
        return [name];
      }),
    );
  }
}

/** @param {number} mm */
const rounded = (mm) => Number(mm.toFixed(1));

/** Returns the digits that show a difference. @param {number} variance */
const digitsOf = (variance) => (variance < 1 ? 3 : variance < 100 ? 1 : 0);

/** Returns the variances in their order, "1: 12.3 → 2: 4.1 ✓", of many only the first and the chosen one. @param {Construction} construction */
export function stepsOf({ variancesMm2, chosen }) {
  const all = variancesMm2.map((variance, at) => ({ variance, at }));
  const listed = all.length > kMostSteps ? all.filter(({ at }) => at === 0 || at === chosen) : all;
  return listed
    .map(
      ({ variance, at }) =>
        `${at + 1}:\u00a0${formatNumber(variance, digitsOf(variance))}${at === chosen ? '\u00a0✓' : ''}`,
    )
    .join(all.length > kMostSteps ? ' … ' : ' → ');
}

/**
 * Returns names for the tips of the arrows: the chosen one, then those that do not overlap names before them.
 * @param {PointOnScreen[]} tips
 * @param {number | null} chosen
 * @returns {[string, string, PointOnScreen][]}
 */
export function numbered(tips, chosen) {
  const order = tips.map((_, at) => at).sort((a, b) => Number(b === chosen) - Number(a === chosen) || a - b);
  /** @type {[string, string, PointOnScreen][]} */
  const named = [];
  for (const at of order) {
    const tip = tips[at];
    if (!tip || (tips.length > kMostSteps && at !== 0 && at !== chosen)) continue;
    const isFree = named.every(([, , other]) => other && Math.hypot(tip[0] - other[0], tip[1] - other[1]) > kNearPx);
    if (isFree) named.push([String(at + 1), 'directions', tip]);
  }
  return named;
}
