// SPDX-License-Identifier: GPL-3.0-or-later
// The buttons for the other downloads, next to the carved model.
import { localise } from '../i18n/catalogue.js';
import { byId, make } from '../dom/dom.js';

/** @typedef {import('../i18n/catalogue.js').Key} Key */

/**
 * @typedef {{ onPicture: () => void, onSettings: () => void, onShare: () => void,
 *   onSymbol: (format: 'svg' | 'png') => void }} ExportListener
 */

export class ExportPanel {
  constructor() {
    /** @type {ExportListener | undefined} */ this.listener_ = undefined;
    const mount = byId('take-away', HTMLElement);
    this.secret_ = make('p', { className: 'field-note' });
    this.secret_.dataset.text = 'exports.secret';
    this.secret_.id = 'take-secret';
    this.secret_.hidden = true;
    this.settings_ = makeButton('exports.settings', 'exports.settingsTitle', () => this.listener_?.onSettings());
    this.share_ = makeButton('exports.share', 'exports.shareTitle', () => this.listener_?.onShare());
    this.symbol_ = [
      makeButton('exports.symbolSvg', 'exports.symbolSvgTitle', () => this.listener_?.onSymbol('svg')),
      makeButton('exports.symbolPng', 'exports.symbolPngTitle', () => this.listener_?.onSymbol('png')),
    ];
    this.picture_ = makeButton('exports.picture', 'exports.pictureTitle', () => this.listener_?.onPicture());
    mount.append(
      make('div', { className: 'take-buttons' }, this.settings_, this.share_, this.picture_, ...this.symbol_),
      this.secret_,
    );
    localise(mount);
  }

  /** @param {ExportListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /** @param {boolean} exists  false: a text alone */
  setSymbol(exists) {
    for (const button of this.symbol_) button.hidden = !exists;
  }

  /** @param {boolean} secret  the text holds a password, so a settings file and a link would contain it */
  setSecret(secret) {
    this.secret_.hidden = !secret;
    for (const button of [this.settings_, this.share_]) {
      if (secret) button.setAttribute('aria-describedby', this.secret_.id);
      else button.removeAttribute('aria-describedby');
    }
  }
}

/** @param {Key} label @param {Key} title @param {() => void} onClick */
function makeButton(label, title, onClick) {
  const button = make('button');
  button.type = 'button';
  button.dataset.text = label;
  button.dataset.textTitle = title;
  button.addEventListener('click', onClick);
  return button;
}
