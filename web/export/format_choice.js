// SPDX-License-Identifier: GPL-3.0-or-later
import { recall, remember } from '../storage/remembered.js';

const kKept = 'format';

/** Has the chooser say what was chosen last, also on the last visit. @param {HTMLSelectElement} chooser */
export function rememberFormat(chooser) {
  const last = recall(kKept);
  if ([...chooser.options].some(({ value }) => value === last)) chooser.value = /** @type {string} */ (last);
  chooser.addEventListener('change', () => remember(kKept, chooser.value));
}
