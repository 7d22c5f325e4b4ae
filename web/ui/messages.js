// SPDX-License-Identifier: GPL-3.0-or-later
// The page's messages: the status line, and errors with their hints.
import { onLanguage } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';
import { byId, make } from '../dom/dom.js';
import { asSentence } from '../i18n/sentences.js';

/** @typedef {import('../i18n/live.js').Words} Words */
/** @typedef {import('../engine/message.js').Message} Message */
/** @typedef {Message | { found: Words, help: Words }} Problem  the page's own problems carry words instead of a code */

export class Messages {
  constructor() {
    this.status_ = byId('status', HTMLElement);
    this.box_ = byId('alert', HTMLElement);
    this.text_ = byId('alert-text', HTMLElement);
    /** @type {Words | undefined} */ this.words_ = undefined;
    /** @type {Problem | undefined} */ this.problem_ = undefined;
    byId('alert-dismiss', HTMLButtonElement).addEventListener('click', () => this.clearError());
    onLanguage(() => this.problem_ && this.showError(this.problem_));
  }

  /** @param {Words} words */
  say(words) {
    this.words_ = words;
    write(this.status_, words);
  }

  /** Tells whether nothing else has been said since. @param {Words} words */
  isSaying(words) {
    return this.words_ === words;
  }

  /** @param {Problem} problem */
  showError(problem) {
    this.problem_ = problem;
    const [finding, help] =
      'code' in problem ? [sentenceOf(problem), hintOf(problem)] : [problem.found(), problem.help()];
    this.text_.replaceChildren(make('strong', { text: asSentence(finding) }));
    if (help) this.text_.append(' ', asSentence(help));
    this.box_.hidden = finding === ''; // hidden until the words have loaded
  }

  clearError() {
    this.problem_ = undefined;
    this.box_.hidden = true;
    this.text_.replaceChildren();
  }
}

/** @typedef {{ label: string, run: () => void }} Remedy  one click applies it */
/** @typedef {{ severity: string, found: string, help: string, remedies?: Remedy[] }} Shown */

/**
 * Fills a list with findings, most severe first.
 * @param {HTMLElement} list
 * @param {Shown[]} findings
 */
export function showFindings(list, findings) {
  const order = ['blocking', 'warning', 'note'];
  const sorted = [...findings].sort((a, b) => order.indexOf(a.severity) - order.indexOf(b.severity));
  list.replaceChildren(
    ...sorted.map(({ severity, found, help, remedies = [] }) =>
      make(
        'li',
        { className: severity },
        make('span', { text: asSentence(found) }),
        ...(help ? [` ${asSentence(help)}`] : []),
        ...remedyButtons(remedies),
      ),
    ),
  );
}

/** @param {Remedy[]} remedies */
export function remedyButtons(remedies) {
  if (remedies.length === 0) return [];
  return [
    make(
      'div',
      { className: 'remedies' },
      ...remedies.map(({ label, run }) => {
        const button = make('button', { className: 'quiet', text: label });
        button.type = 'button';
        button.addEventListener('click', run);
        return button;
      }),
    ),
  ];
}
