// SPDX-License-Identifier: GPL-3.0-or-later
import { recall, remember } from '../storage/remembered.js';

const kKept = 'format';

/** Restores the last choice, also of the last visit, and remembers new ones. @param {HTMLSelectElement} chooser */
export function rememberFormat(chooser) {
  const last = recall(kKept);
  if ([...chooser.options].some(({ value }) => value === last)) chooser.value = /** @type {string} */ (last);
  chooser.addEventListener('change', () => remember(kKept, chooser.value));
}
