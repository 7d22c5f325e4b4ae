// SPDX-License-Identifier: GPL-3.0-or-later
// The buttons over the 3D view.
import { byId } from './dom.js';

/**
 * @typedef {object} ToolbarListener
 * @property {(carved: boolean) => void} onCarved
 * @property {() => void} onReaderView
 * @property {() => void} onFit
 * @property {(shown: boolean) => void} onInspector
 */

export class ViewToolbar {
  /** @param {ToolbarListener} listener */
  constructor({ onCarved, onReaderView, onFit, onInspector }) {
    this.carved_ = byId('show-carved', HTMLButtonElement);
    this.reader_ = byId('reader-view', HTMLButtonElement);
    this.inspector_ = byId('inspector', HTMLButtonElement);
    this.hint_ = byId('view-hint', HTMLElement);
    this.carved_.addEventListener('click', () => onCarved(toggle(this.carved_)));
    this.inspector_.addEventListener('click', () => onInspector(toggle(this.inspector_)));
    this.reader_.addEventListener('click', onReaderView);
    byId('fit', HTMLButtonElement).addEventListener('click', onFit);
  }

  /** @param {boolean} exists  a carved model @param {boolean} shown */
  setCarved(exists, shown) {
    this.carved_.disabled = !exists;
    this.carved_.setAttribute('aria-pressed', String(shown));
  }

  /** @param {boolean} placed  a code has its place */
  setPlaced(placed) {
    this.reader_.disabled = !placed;
    this.hint_.hidden = placed;
  }

  get inspectorShown() {
    return this.inspector_.getAttribute('aria-pressed') === 'true';
  }
}

/** @param {HTMLButtonElement} button @returns {boolean} the new state */
function toggle(button) {
  const pressed = button.getAttribute('aria-pressed') !== 'true';
  button.setAttribute('aria-pressed', String(pressed));
  return pressed;
}
