// SPDX-License-Identifier: GPL-3.0-or-later
// The phone view: the frame of a phone's camera, a caption with the decoded text, and a switch between the carved model
// and its print.
import { onLanguage, text } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { make } from '../dom/dom.js';
import { LostModules } from './lost_modules.js';

/** @typedef {import('../engine/types.js').CodeOnScreen} CodeOnScreen */
/** @typedef {{ print: import('../engine/types.js').Print, modules: number, reads: boolean }} SeenPrint */

export class ReaderView {
  /**
   * @param {HTMLElement} overlays
   * @param {HTMLElement} surface  covers the canvas
   * @param {(picture: import('../engine/types.js').GreyImage | undefined) => void} onPrint  shows the picture of a print
   *   on the surface; undefined: hides it
   */
  constructor(overlays, surface, onPrint) {
    this.onPrint_ = onPrint;
    this.marks_ = new LostModules(surface);
    /** @type {SeenPrint | undefined} */ this.drawn_ = undefined;
    this.caption_ = make('p');
    this.designed_ = this.makeSwitch_(false);
    this.printed_ = this.makeSwitch_(true);
    this.switch_ = make('div', { className: 'of-print' }, this.designed_, this.printed_);
    this.switch_.setAttribute('role', 'group');
    this.box_ = make(
      'div',
      { className: 'reader-view' },
      make('div', { className: 'finder' }),
      this.switch_,
      this.caption_,
    );
    this.box_.hidden = true;
    this.box_.setAttribute('role', 'group');
    overlays.append(this.box_);
    /** @type {string | undefined} */ this.read_ = undefined;
    /** @type {SeenPrint | undefined} */ this.print_ = undefined;
    this.showsPrint_ = false;
    write(this.caption_, () => this.words_());
    onLanguage(() => this.name_());
    this.name_();
  }

  get shown() {
    return !this.box_.hidden;
  }

  enter() {
    this.box_.hidden = false;
    this.say_();
  }

  leave() {
    this.box_.hidden = true;
    this.say_();
  }

  /**
   * @param {string | undefined} read  text decoded from the carved model if it is shown; '': not decoded; undefined: no
   *   carved model is shown
   */
  show(read) {
    this.read_ = read;
    this.say_();
  }

  /** @param {SeenPrint | undefined} print  of the carved model, once simulated */
  showPrint(print) {
    this.print_ = print;
    this.say_();
  }

  /** @param {CodeOnScreen | null} code  the code's position on the screen */
  update(code) {
    this.marks_.place(code);
  }

  /** @param {boolean} printed */
  makeSwitch_(printed) {
    const button = make('button');
    button.type = 'button';
    button.addEventListener('click', () => {
      this.showsPrint_ = printed;
      this.say_();
    });
    return button;
  }

  name_() {
    this.box_.setAttribute('aria-label', text('view.reader'));
    this.switch_.setAttribute('aria-label', text('view.ofPrint'));
    this.designed_.textContent = text('view.designed');
    this.printed_.textContent = text('view.printed');
  }

  /** The print, if it is shown. @returns {SeenPrint | undefined} */
  get seenPrint_() {
    return this.showsPrint_ && this.read_ !== undefined ? this.print_ : undefined;
  }

  say_() {
    const { seenPrint_: seen } = this;
    this.switch_.hidden = this.read_ === undefined || !this.print_;
    this.designed_.setAttribute('aria-pressed', String(!seen));
    this.printed_.setAttribute('aria-pressed', String(seen !== undefined));
    this.draw_(this.shown ? seen : undefined);
    write(this.caption_, () => this.words_());
    this.box_.dataset.read = this.read_ === undefined ? '' : String(seen ? seen.reads : this.read_ !== '');
  }

  /** Draws the print on the surface, or the designed model. @param {SeenPrint | undefined} seen */
  draw_(seen) {
    if (seen === this.drawn_) return;
    this.drawn_ = seen;
    this.onPrint_(seen?.print.picture);
    if (seen) this.marks_.show(seen.print.misread, seen.modules);
    else this.marks_.hide();
  }

  words_() {
    if (this.read_ === undefined) return text('view.readerAsks');
    const { seenPrint_: seen } = this;
    if (seen) return text(seen.reads ? 'view.printRead' : 'view.printUnread', { lost: seen.print.misread.length });
    return this.read_ ? text('view.readerRead', { text: this.read_ }) : text('view.readerNothing');
  }
}
