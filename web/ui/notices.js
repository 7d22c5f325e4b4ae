// SPDX-License-Identifier: GPL-3.0-or-later
// Bars over the view that offer something and wait. Unlike an alert, a notice reports no error.
import { make } from '../dom/dom.js';

/** @typedef {{ label: string, run: () => void, primary?: boolean }} NoticeAction  choosing it closes the bar */

export class Notices {
  /** @param {HTMLElement} parent */
  constructor(parent) {
    this.list_ = make('div', { className: 'notices' });
    this.list_.setAttribute('aria-live', 'polite');
    parent.append(this.list_);
    /** @type {Map<string, HTMLElement>} */ this.bars_ = new Map();
  }

  /**
   * @param {string} id  of the offer; each has at most one bar
   * @param {string} words
   * @param {NoticeAction[]} actions
   */
  show(id, words, actions) {
    this.remove(id);
    const buttons = actions.map(({ label, run, primary }) => {
      const button = make('button', { className: primary ? 'primary' : 'quiet', text: label });
      button.type = 'button';
      button.addEventListener('click', () => {
        this.remove(id);
        run();
      });
      return button;
    });
    const bar = make(
      'div',
      { className: 'notice' },
      make('p', { text: words }),
      make('div', { className: 'notice-actions' }, ...buttons),
    );
    this.bars_.set(id, bar);
    this.list_.append(bar);
  }

  /** @param {string} id */
  remove(id) {
    this.bars_.get(id)?.remove();
    this.bars_.delete(id);
  }
}
