// SPDX-License-Identifier: GPL-3.0-or-later
// Disables buttons and says why.
import { text } from '../i18n/catalogue.js';

/** @typedef {import('../i18n/catalogue.js').Key} Key */

/** Titles of enabled buttons. @type {WeakMap<HTMLButtonElement, Key | undefined>} */
const usual = new WeakMap();

/**
 * Disables a button, or enables it. While it is disabled, its title, which screen readers read as its description, says
 * why.
 * @param {HTMLButtonElement} button
 * @param {Key} [why]  what is missing; absent: the button is enabled
 */
export function setDisabled(button, why) {
  if (!usual.has(button)) usual.set(button, /** @type {Key | undefined} */ (button.dataset.textTitle));
  button.disabled = why !== undefined;
  const key = why ?? usual.get(button);
  if (key) {
    button.dataset.textTitle = key; // written again when the language changes
    button.title = text(key);
  } else {
    delete button.dataset.textTitle;
    button.removeAttribute('title');
  }
}
