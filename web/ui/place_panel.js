// SPDX-License-Identifier: GPL-3.0-or-later
// The code's placement: its width and its exact centre.
import { onLanguage, text } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { byId } from '../dom/dom.js';
import { formatMm } from '../i18n/format.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';
import { asSentence } from '../i18n/sentences.js';
import { showSpotCost } from './carve_panel.js';
import { showFindings } from './messages.js';
import { showStep } from './steps.js';

/** @typedef {import('../engine/types.js').Placement} Placement */
/** @typedef {import('../engine/types.js').SettingChange} SettingChange */
/** @typedef {import('../engine/message.js').Message} Message */
/** @typedef {[number, number, number]} Point */

export class PlacePanel {
  constructor() {
    /** @type {(centreMm: Point) => void} */ this.onCentre_ = () => {};
    /** @type {(change: SettingChange, label: string) => void} */ this.onRemedy_ = () => {};
    this.concerns_ = byId('place-concerns', HTMLElement);
    /** @type {Message[]} */ this.shown_ = [];
    onLanguage(() => this.showConcerns_());
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

  /** @param {(change: SettingChange, label: string) => void} onRemedy  called with a change that helps here */
  listenToRemedies(onRemedy) {
    this.onRemedy_ = onRemedy;
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
    aim.hidden = !placement || placement.capitalMm !== null; // people read a text at any angle
    showSpotCost(placement?.colourLayers ?? 0);
    this.showDepths(undefined);
    this.shown_ = placement?.concerns ?? [];
    this.showConcerns_();
    if (!placement) return showStep('place', 'open', () => text('page.placeNone'));
    const { concerns, aimToleranceDeg, forgiving } = placement;
    write(aim, () => text(!forgiving ? 'page.aimLittle' : 'page.aim', { deg: Math.floor(aimToleranceDeg) }));
    return showStep('place', concerns.length > 0 ? 'warn' : 'done', () => sizeInWords(placement));
  }

  /** Says how deep the placed code will be. @param {import('../engine/types.js').FoundDepths | undefined} depths */
  showDepths(depths) {
    const line = byId('placement-depth', HTMLElement);
    line.hidden = depths === undefined;
    if (depths)
      write(line, () => text('page.placeDepths', { mean: formatMm(depths.meanMm), deepest: formatMm(depths.maxMm) }));
  }

  /** Says why no spot is proposed, until the code has one. @param {Message} problem */
  explain(problem) {
    this.shown_ = [problem];
    this.showConcerns_();
  }

  showConcerns_() {
    showFindings(
      this.concerns_,
      this.shown_.map((concern) => {
        const label = text('page.paintInstead');
        const paint = { label, run: () => this.onRemedy_(kPaint, label) };
        const isThin = kThin.includes(concern.code);
        const isSpotless = concern.code.startsWith(kNoSpot);
        return {
          severity: 'warning',
          found: sentenceOf(concern),
          help: [hintOf(concern), ...(isSpotless ? [text('page.orClick')] : [])].map(asSentence).join(' '),
          remedies: isThin ? [paint] : [],
        };
      }),
    );
  }
}

const kNoSpot = 'no-spot'; // begins the codes of the reasons why a search finds no spot
const kThin = ['nothing-can-be-carved', 'nothing-can-be-carved-over-shell', 'no-spot-wall-too-thin'];

/** A code that needs no wall. @type {SettingChange} */
const kPaint = { setting: 'mark', value: 'paint' };

const kWorthSaying = 1.01; // ratio of two sizes

/** @param {Placement} placement */
function sizeInWords({ symbolMm, largestMm, sizeMode, rotationDeg }) {
  const width = formatMm(symbolMm);
  if (largestMm > kWorthSaying * symbolMm)
    return text(sizeMode === 'fixed' ? 'page.placeFits' : 'page.placeWall', { width, largest: formatMm(largestMm) });
  const deg = Math.round(rotationDeg);
  return sizeMode === 'best' && deg !== 0
    ? text('page.placeTurned', { width, deg })
    : text('page.placeState', { width });
}
