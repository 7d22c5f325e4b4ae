// SPDX-License-Identifier: GPL-3.0-or-later
// What the page says: the status line, and errors with what was found and what helps.
import { byId, make } from './dom.js';

/** @typedef {{ message: string, hint: string }} Words */

export class Messages {
  constructor() {
    this.status_ = byId('status', HTMLElement);
    this.box_ = byId('alert', HTMLElement);
    this.text_ = byId('alert-text', HTMLElement);
    byId('alert-dismiss', HTMLButtonElement).addEventListener('click', () => this.clearError());
  }

  /** @param {string} text */
  say(text) {
    if (this.status_.textContent !== text) this.status_.textContent = text;  // the same again would be read out again
  }

  /** @param {Words} words */
  showError({ message, hint }) {
    this.text_.replaceChildren(make('strong', { text: asSentence(message) }));
    if (hint) this.text_.append(' ', asSentence(hint));
    this.box_.hidden = false;
  }

  clearError() {
    this.box_.hidden = true;
    this.text_.replaceChildren();
  }
}

/** Messages come without a full stop. @param {string} text */
export function asSentence(text) {
  const capital = text.charAt(0).toUpperCase() + text.slice(1);
  return /[.!?…]$/.test(capital) ? capital : `${capital}.`;
}

/**
 * Fills a list with findings, worst first.
 * @param {HTMLElement} list
 * @param {{ severity: string, message: string, hint: string }[]} findings
 */
export function showFindings(list, findings) {
  const order = ['blocking', 'warning', 'note'];
  const sorted = [...findings].sort((a, b) => order.indexOf(a.severity) - order.indexOf(b.severity));
  list.replaceChildren(...sorted.map(({ severity, message, hint }) => make('li', { className: severity },
    make('span', { text: asSentence(message) }), ...(hint ? [make('span', { className: 'remedy', text: ` ${asSentence(hint)}` })] : []))));
}
