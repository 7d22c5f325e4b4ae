// SPDX-License-Identifier: GPL-3.0-or-later
// What the code says.
import { text } from '../text/catalogue.js';
import { byId } from './dom.js';
import { showStep } from './steps.js';

/** @typedef {import('../engine/types.js').Placement} Placement */

const kTypingPauseMs = 250;

export class CodePanel {
  /** @param {() => void} onChange  once typing pauses */
  constructor(onChange) {
    this.text_ = byId('text', HTMLTextAreaElement);
    /** @type {ReturnType<typeof setTimeout> | undefined} */ let pause;
    this.text_.addEventListener('input', () => {
      clearTimeout(pause);
      pause = setTimeout(onChange, kTypingPauseMs);
    });
    this.showSymbol(undefined);
  }

  get text() {
    return this.text_.value;
  }

  set text(value) {
    this.text_.value = value;
  }

  /** @param {Placement | undefined} placement  of the symbol */
  showSymbol(placement) {
    if (placement) showStep('code', 'done', () => text('page.codeState', { version: placement.version, modules: placement.modules }));
    else showStep('code', 'todo', () => '');
  }
}
