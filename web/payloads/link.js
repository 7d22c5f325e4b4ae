// SPDX-License-Identifier: GPL-3.0-or-later
// Web addresses in the fields of a content. The engine advises on texts that were meant to be links (qr/link_advice.h).

const kWebAddress = /^https?:\/\//i;

/** @param {string} text */
export const isWebAddress = (text) => kWebAddress.test(text);

/**
 * Adds https:// to a web address without a scheme.
 * @param {string} address
 * @returns {string | undefined}  undefined if it is no web address
 */
export function withScheme(address) {
  const trimmed = address.trim();
  const whole = kWebAddress.test(trimmed) ? trimmed : `https://${trimmed}`;
  const host = /^https?:\/\/([^/?#]*)/i.exec(whole)?.[1] ?? '';
  const isAddress = !/\s/.test(whole) && host.includes('.') && URL.canParse(whole);
  return isAddress ? whole : undefined;
}
