// SPDX-License-Identifier: GPL-3.0-or-later
// Remembers small choices for the next visit. If storage is full, blocked or absent, they are forgotten.

/** @param {string} name @returns {string | undefined} */
export function recall(name) {
  try {
    return localStorage.getItem(`qrelief.${name}`) ?? undefined;
  } catch {
    return undefined;
  }
}

/** @param {string} name @param {string} value */
export function remember(name, value) {
  try {
    localStorage.setItem(`qrelief.${name}`, value);
  } catch {
    // The choice applies to this visit only.
  }
}
