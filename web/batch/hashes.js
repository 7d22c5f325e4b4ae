// SPDX-License-Identifier: GPL-3.0-or-later

/** Returns the SHA-256 in lower-case hexadecimal. @param {Uint8Array<ArrayBuffer> | string} value */
export async function sha256(value) {
  const bytes = typeof value === 'string' ? new TextEncoder().encode(value) : value;
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
  return Array.from(digest, (byte) => byte.toString(16).padStart(2, '0')).join('');
}
