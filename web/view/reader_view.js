// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of a phone's camera around the reader's view, and under it what was read.
import { text } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { make } from '../dom/dom.js';

export class ReaderView {
  /** @param {HTMLElement} overlays */
  constructor(overlays) {
    this.caption_ = make('p');
    this.box_ = make('div', { className: 'reader-view' }, make('div', { className: 'finder' }), this.caption_);
    this.box_.hidden = true;
    this.box_.setAttribute('role', 'group');
    overlays.append(this.box_);
    /** @type {string | undefined} */ this.read_ = undefined;
    write(this.caption_, () => this.words_());
  }

  get shown() {
    return !this.box_.hidden;
  }

  enter() {
    this.box_.hidden = false;
    this.box_.setAttribute('aria-label', text('view.reader'));
    this.say_();
  }

  leave() {
    this.box_.hidden = true;
  }

  /** @param {string | undefined} read  of the carved model, where that is seen; '': nothing */
  show(read) {
    this.read_ = read;
    this.say_();
  }

  say_() {
    write(this.caption_, () => this.words_());
    this.box_.dataset.read = this.read_ === undefined ? '' : String(this.read_ !== '');
  }

  words_() {
    if (this.read_ === undefined) return text('view.readerAsks');
    return this.read_ ? text('view.readerRead', { text: this.read_ }) : text('view.readerNothing');
  }
}
