// SPDX-License-Identifier: GPL-3.0-or-later
// The buttons Engrave, Engrave again and Cancel, and the progress bar.
import { text } from '../i18n/catalogue.js';
import { setDisabled } from '../dom/set_disabled.js';
import { byId } from '../dom/dom.js';

/** @typedef {{ onEngrave: () => void, onCancel: () => void }} WorkListener */

export class WorkPanel {
  constructor() {
    /** @type {WorkListener | undefined} */ this.listener_ = undefined;
    this.engrave_ = byId('engrave', HTMLButtonElement);
    this.again_ = byId('engrave-again', HTMLButtonElement); // next to an outdated result
    this.cancel_ = byId('cancel', HTMLButtonElement);
    this.progress_ = byId('progress', HTMLProgressElement);
    byId('panel', HTMLFormElement).addEventListener('submit', (event) => {
      event.preventDefault();
      if (!this.engrave_.disabled) this.listener_?.onEngrave();
    });
    this.setEngraveDisabled('page.whyNoModel');
    this.cancel_.addEventListener('click', () => this.listener_?.onCancel());
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape' && !this.cancel_.hidden && !document.querySelector('dialog[open]'))
        this.listener_?.onCancel();
    });
  }

  /** @param {WorkListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /** Sets the label of the Engrave button. @param {'page.engrave' | 'batch.engraveFirst'} key */
  nameEngrave(key) {
    this.engrave_.dataset.text = key; // used again when the language changes
    this.engrave_.textContent = text(key);
  }

  /** @param {import('../dom/set_disabled.js').Key} [why]  the buttons do nothing; absent: they engrave */
  setEngraveDisabled(why) {
    for (const button of [this.engrave_, this.again_]) setDisabled(button, why);
  }

  /** @param {string} stage @param {number} [reached]  absent: the duration is unknown */
  begin(stage, reached) {
    this.focusReturns_ = [this.engrave_, this.again_].some((button) => button === document.activeElement);
    this.setEngraveDisabled('page.whyBusy');
    this.cancel_.hidden = false;
    this.progress_.hidden = false;
    if (reached === undefined) this.progress_.removeAttribute('value');
    else this.progress_.value = reached;
    this.progress_.setAttribute('aria-label', stage);
    if (this.focusReturns_) this.cancel_.focus();
  }

  /** @param {number} fraction @param {string} stage */
  update(fraction, stage) {
    this.progress_.value = fraction;
    this.progress_.setAttribute('aria-label', stage);
  }

  end() {
    const hadFocus = document.activeElement === this.cancel_;
    this.cancel_.hidden = true;
    this.progress_.hidden = true;
    if (hadFocus) this.engrave_.focus();
  }
}
