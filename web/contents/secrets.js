// SPDX-License-Identifier: GPL-3.0-or-later
// What must not be kept on a device without being asked: the password in a Wi-Fi text.

const kWifi = /^(\s*WIFI:)(.*)$/is;
const kFields = /(?:\\[^]|[^;\\]|\\$)+/g;  // between semicolons that no backslash stands before
const kPassword = /^\s*P:/i;

/**
 * The text as it may be stored: a Wi-Fi text without its password, however far it has been typed; any other as it is.
 * @param {string} text
 */
export const withoutSecrets = (text) => text.replace(kWifi, (_, start, fields) =>
  start + fields.replace(kFields, (/** @type {string} */ field) => kPassword.exec(field)?.[0] ?? field));

/** @param {string} text */
export const holdsSecret = (text) => withoutSecrets(text) !== text;
