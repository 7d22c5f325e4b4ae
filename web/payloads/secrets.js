// SPDX-License-Identifier: GPL-3.0-or-later
// Finds secrets that must not be stored on the device unasked: the password in a Wi-Fi text.

const kWifi = /^(\s*WIFI:)(.*)$/is;
const kFields = /(?:\\[^]|[^;\\]|\\$)+/g; // separated by unescaped semicolons
const kPassword = /^\s*P:/i;

/**
 * Removes the password from a Wi-Fi text, even an incomplete one, and returns any other text unchanged.
 * @param {string} text
 */
export const withoutSecrets = (text) =>
  text.replace(
    kWifi,
    (_, start, fields) =>
      start + fields.replace(kFields, (/** @type {string} */ field) => kPassword.exec(field)?.[0] ?? field),
  );

/** @param {string} text */
export const holdsSecret = (text) => withoutSecrets(text) !== text;
