// SPDX-License-Identifier: GPL-3.0-or-later
// The code's placement: its width, its exact centre and what may fail there. What lamps make fail stands beside the lamps.
import { onLanguage, text } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { byId } from '../dom/dom.js';
import { formatMm } from '../i18n/format.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';
import { message } from '../engine/message.js';
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
    this.lightGroup_ = byId('light-group', HTMLDetailsElement);
    this.lightConcerns_ = byId('light-concerns', HTMLElement);
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
    const isFine = concerns.every((concern) => this.isBesideLamps_(concern));
    return showStep('place', isFine ? 'done' : 'warn', () => sizeInWords(placement));
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

  /** @param {Message} concern */
  isBesideLamps_({ code }) {
    return kOfLamps.includes(code) && !this.lightGroup_.hidden;
  }

  showConcerns_() {
    const ofLamps = this.shown_.filter((concern) => this.isBesideLamps_(concern));
    const others = this.shown_.filter((concern) => !ofLamps.includes(concern));
    const shown = (/** @type {Message} */ concern) => this.inWords_(concern);
    if (ofLamps.length > 0 && !this.lightConcerns_.firstChild) this.lightGroup_.open = true; // unless the user closed it
    showFindings(this.concerns_, others.map(shown));
    showFindings(this.lightConcerns_, ofLamps.map(shown));
  }

  /** @param {Message} concern @returns {import('./messages.js').Shown} */
  inWords_(concern) {
    const isSpotless = concern.code.startsWith(kNoSpot);
    return {
      severity: 'warning',
      found: sentenceOf(concern),
      help: [hintOf(concern), ...(isSpotless ? [text('page.orClick')] : [])].map(asSentence).join(' '),
      remedies: changesFor(concern).map(({ words, change }) => {
        const label = words();
        return { label, run: () => this.onRemedy_(change, label) };
      }),
    };
  }
}

const kNoSpot = 'no-spot'; // begins the codes of the reasons why a search finds no spot
const kThin = ['nothing-can-be-carved', 'nothing-can-be-carved-over-shell', 'no-spot-wall-too-thin'];

const kOfLamps = ['spot-lit-unevenly-by-lamps', 'spot-wants-another-lamp'];

/**
 * Returns the changes of one click that help, with their labels.
 * @param {Message} concern
 * @returns {{ words: import('../i18n/live.js').Words, change: SettingChange }[]}
 */
export function changesFor({ code, values: { lamp, code: asked } }) {
  if (kThin.includes(code)) return [{ words: kWords.paint, change: { setting: 'mark', value: 'paint' } }];
  if (lamp && 'term' in lamp) return [{ words: kWords.move, change: { setting: 'light', value: lamp.term } }];
  const isOfFixedSize = asked && 'cause' in asked && 'size' in asked.cause.values;
  if (code.startsWith(kNoSpot) && isOfFixedSize)
    return [{ words: kWords.enlarge, change: { setting: 'size', value: 'best' } }];
  return [];
}

const kWords = {
  paint: () => text('page.paintInstead'),
  move: () => text('page.moveLamp'),
  enlarge: () => sentenceOf(message('remedy-as-large-as-fits')),
};

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
