// SPDX-License-Identifier: GPL-3.0-or-later
// Suggested spots for the code, and the possible sizes, or the room for a fixed one, as colours on the model.
import { onLanguage, text } from '../i18n/catalogue.js';
import { setDisabled } from '../dom/set_disabled.js';
import { byId, make } from '../dom/dom.js';
import { formatPlain } from '../i18n/format.js';
import { sentenceOf } from '../i18n/messages.js';

/** @typedef {import('../engine/types.js').Spots} Spots */

/**
 * @typedef {object} SpotsListener
 * @property {() => void} onSuggest
 * @property {(index: number) => void} onSpot
 * @property {(shown: boolean) => void} onSizes
 */

export class SpotsPanel {
  /** @param {import('../view/legend.js').Legend} legend */
  constructor(legend) {
    /** @type {SpotsListener | undefined} */ this.listener_ = undefined;
    this.suggest_ = byId('suggest', HTMLButtonElement);
    this.list_ = byId('spots', HTMLUListElement);
    this.note_ = byId('spots-note', HTMLParagraphElement);
    this.sizes_ = byId('show-sizes', HTMLButtonElement);
    this.legend_ = legend;
    this.topMm_ = 0;
    /** @type {number | null} */ this.fixedMm_ = null;
    /** @type {Spots['spots']} */ this.spots_ = [];
    setDisabled(this.suggest_, 'page.whyNoModel');
    setDisabled(this.sizes_, 'page.whyNoSizes');
    onLanguage(() => this.nameSpots_());
    this.suggest_.addEventListener('click', () => this.listener_?.onSuggest());
    this.sizes_.addEventListener('click', () => {
      const areShown = this.sizes_.getAttribute('aria-pressed') !== 'true';
      this.setSizesShown(areShown);
      this.listener_?.onSizes(areShown);
    });
  }

  /** @param {SpotsListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /** @param {import('../dom/set_disabled.js').Key} [why]  the search does not start; absent: it may */
  setDisabled(why) {
    setDisabled(this.suggest_, why);
  }

  /**
   * @param {Spots} found
   * @param {boolean} withSizes  show the sizes, too
   */
  show({ spots, topMm, fixedMm }, withSizes) {
    this.spots_ = spots;
    this.list_.replaceChildren(
      ...spots.map((_, index) => {
        const picture = make('canvas');
        picture.setAttribute('aria-hidden', 'true');
        const button = make('button', {}, picture, make('span', { className: 'name' }));
        button.type = 'button';
        button.setAttribute('aria-pressed', 'false');
        button.addEventListener('click', () => this.listener_?.onSpot(index));
        return make('li', {}, button);
      }),
    );
    this.nameSpots_();
    this.topMm_ = topMm;
    this.fixedMm_ = fixedMm;
    setDisabled(this.sizes_);
    this.setSizesShown(withSizes);
    if (withSizes) this.list_.scrollIntoView({ block: 'nearest' });
  }

  nameSpots_() {
    [...this.list_.querySelectorAll('.name')].forEach((name, index) =>
      name.replaceChildren(
        text('page.spot', { index: index + 1 }),
        make('span', { text: factsOf(this.spots_[index]) }),
        ...concernsOf(this.spots_[index]),
      ),
    );
    this.note_.hidden = !this.known || this.spots_.some(({ concerns }) => concerns.length === 0);
    this.note_.textContent = text('page.noGoodSpot');
  }

  /**
   * Draws the code at a spot as its viewer sees it.
   * @param {number} index
   * @param {import('../engine/types.js').ColourImage} picture
   */
  showPicture(index, { width, height, pixels }) {
    const canvas = this.list_.querySelectorAll('canvas')[index];
    if (!canvas || width === 0) return;
    Object.assign(canvas, { width, height });
    canvas.getContext('2d')?.putImageData(new ImageData(new Uint8ClampedArray(pixels.buffer), width, height), 0, 0);
    canvas.classList.add('drawn');
  }

  clear() {
    this.list_.replaceChildren();
    this.note_.hidden = true;
    setDisabled(this.sizes_, 'page.whyNoSizes');
    this.setSizesShown(false);
  }

  /** @param {number} [index]  undefined if the code's centre is elsewhere */
  mark(index) {
    [...this.list_.querySelectorAll('button')].forEach((button, i) =>
      button.setAttribute('aria-pressed', String(i === index)),
    );
  }

  get known() {
    return this.list_.childElementCount > 0;
  }

  /** @param {boolean} areShown */
  setSizesShown(areShown) {
    this.sizes_.setAttribute('aria-pressed', String(areShown));
    if (areShown && this.fixedMm_ !== null) this.legend_.showRoom(this.fixedMm_);
    else if (areShown) this.legend_.show('sizes', this.topMm_);
    else this.legend_.hide('sizes');
  }
}

/** @param {Spots['spots'][number]} spot */
const factsOf = ({ sizeMm, aimToleranceDeg }) =>
  text('page.roomFor', {
    size: `${formatPlain(sizeMm, sizeMm < 10 ? 1 : 0)}\u00a0mm`,
    deg: Math.floor(aimToleranceDeg),
  });

/** Returns the warnings about a spot. @param {Spots['spots'][number]} spot */
const concernsOf = ({ concerns }) =>
  concerns.map((concern) => make('span', { className: 'warning', text: sentenceOf(concern) }));
