// SPDX-License-Identifier: GPL-3.0-or-later
// The mode in which the next click in the view picks the face of the model that lies on the build plate.
import { text } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { setDisabled } from '../dom/set_disabled.js';
import { byId } from '../dom/dom.js';

/** @typedef {{ onPick: (picking: boolean) => void }} FacePickerListener  the mode began or ended */

export class FacePicker {
  /** @param {HTMLElement} view  holds the canvas */
  constructor(view) {
    /** @type {FacePickerListener | undefined} */ this.listener_ = undefined;
    this.view_ = view;
    this.button_ = byId('lay-face', HTMLButtonElement);
    setDisabled(this.button_, 'page.whyNoModel');
    this.hint_ = byId('lay-hint', HTMLElement);
    this.words_ = byId('lay-words', HTMLElement);
    this.isPicking = false;
    this.button_.addEventListener('click', () => this.pick_(!this.isPicking));
    byId('lay-cancel', HTMLButtonElement).addEventListener('click', () => this.pick_(false));
    document.addEventListener(
      'keydown',
      (event) => {
        if (event.key !== 'Escape' || !this.isPicking) return;
        event.stopPropagation(); // this Escape ends the mode and nothing else
        this.pick_(false);
      },
      { capture: true },
    );
  }

  /** @param {FacePickerListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /** @param {import('../dom/set_disabled.js').Key} [why]  no face can be picked; absent: one can */
  setDisabled(why) {
    setDisabled(this.button_, why);
    if (why && this.isPicking) this.pick_(false);
  }

  /** Ends the mode if a click hit the model, else says that it missed. @param {boolean} hit */
  handlePick(hit) {
    if (hit) this.pick_(false);
    else write(this.words_, () => text('view.layMissed'));
  }

  /** @param {boolean} picking */
  pick_(picking) {
    this.isPicking = picking;
    this.button_.setAttribute('aria-pressed', String(picking));
    this.hint_.hidden = !picking;
    this.view_.parentElement?.classList.toggle('picking', picking);
    write(this.words_, () => (this.isPicking ? text('view.layFace') : ''));
    // In the view, Enter picks the face in the middle.
    if (picking) this.view_.querySelector('canvas')?.focus({ preventScroll: true });
    else if (!this.button_.disabled) this.button_.focus({ preventScroll: true });
    this.listener_?.onPick(picking);
  }
}
