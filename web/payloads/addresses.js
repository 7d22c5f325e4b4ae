// SPDX-License-Identifier: GPL-3.0-or-later
// Checks telephone numbers, e-mail addresses and hosts and converts them to their machine-readable form.

/** A valid e-mail address as in HTML, but with any letters in the domain. */
const kEmail = /^[\w.!#$%&'*+/=?^`{|}~-]+@([^\s@.]+\.)+[^\s@.]+$/;

const kMostDigits = 15; // ITU-T E.164
const kLeastDigits = 3;

/**
 * Converts a host to ASCII (xn--…).
 * @param {string} host  @returns {string | undefined} undefined if it is no host
 */
export function asciiHost(host) {
  try {
    return new URL(`http://${host}/`).hostname;
  } catch {
    return undefined;
  }
}

/**
 * Splits an e-mail address.
 * @param {string} address
 * @returns {{ local: string, host: string } | undefined}  the host in ASCII; undefined if it is no address
 */
export function parseEmail(address) {
  const trimmed = address.trim();
  const at = trimmed.lastIndexOf('@');
  const host = kEmail.test(trimmed) ? asciiHost(trimmed.slice(at + 1)) : undefined;
  return host === undefined ? undefined : { local: trimmed.slice(0, at), host };
}

/**
 * Normalises a telephone number.
 * @param {string} number  in any common notation
 * @returns {{ dialled: string, international: boolean } | undefined}  undefined if it cannot be dialled
 */
export function parsePhone(number) {
  const dialled = number
    .trim()
    .replace(/^00(?=[1-9])/, '+')
    .replace(/\(0\)/g, '')
    .replace(/[\s\u00a0().\-/\u2010-\u2015]/g, '');
  if (!/^\+?[0-9*#]+$/.test(dialled)) return undefined;
  const digits = dialled.replace(/\D/g, '').length;
  const international = dialled.startsWith('+');
  if (digits < kLeastDigits || digits > kMostDigits || (international && /[*#]/.test(dialled))) return undefined;
  return { dialled, international };
}
