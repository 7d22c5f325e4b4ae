// SPDX-License-Identifier: GPL-3.0-or-later
// Small choices kept for the next visit. Storage may be full, forbidden or absent: then there is no next time.

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
    // The choice holds for this visit.
  }
}
