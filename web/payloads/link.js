// SPDX-License-Identifier: GPL-3.0-or-later
// Checks texts that are, or were meant to be, links, and suggests corrections and shorter forms.
import { asciiHost } from './addresses.js';

/** @typedef {import('./types.js').Key} Key */

/**
 * Advice on a text. `fixed`: the corrected text.
 * @typedef {{ severity: 'warning' | 'note', key: Key, values?: Record<string, string | number>, fixed?: string, fixKey?: Key }} Advice
 */

/** host[:port][/path…]: labels of letters, digits and hyphens, the last one a possible top-level domain. */
const kBareAddress =
  /^(?:[\p{L}\p{N}](?:[\p{L}\p{N}-]*[\p{L}\p{N}])?\.)+(?:\p{L}{2,}|xn--[a-z0-9-]+)(?::\d{1,5})?(?:[/?#]\S*)?$/u;
const kWebAddress = /^https?:\/\//i;
/** Looks like an address but is more often a file name: do not suggest a link. */
const kFileEnding = /^[^/?#]*\.(?:stl|obj|ply|off|3mf|txt|pdf|png|jpe?g|svg|json|zip|gcode|docx?|xlsx?|html?|md)$/i;

/** Parameters that only tell the site where a visitor came from; the page is the same without them. */
const kTracking =
  /^(?:utm_\w+|fbclid|gclid|gclsrc|dclid|gbraid|wbraid|msclkid|twclid|ttclid|li_fat_id|yclid|igshid|igsh|mc_cid|mc_eid|mkt_tok|srsltid|_hsenc|_hsmi|_ga|_gl|vero_id|oly_anon_id|oly_enc_id)$/i;

const kLongLink = 60; // characters; longer links need version 5 or more

/** @param {string} text  @returns {{ scheme: string, host: string, rest: string } | undefined}  rest: with its slash */
function splitWebAddress(text) {
  const parts = /^(https?:\/\/)([^/?#]*)(.*)$/is.exec(text);
  return parts ? { scheme: parts[1], host: parts[2], rest: parts[3] } : undefined;
}

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
  const host = splitWebAddress(whole)?.host ?? '';
  const isAddress = !/\s/.test(whole) && host.includes('.') && URL.canParse(whole);
  return isAddress ? whole : undefined;
}

/**
 * Removes the tracking parameters of a link and leaves the rest unchanged.
 * @param {string} link
 */
export function withoutTracking(link) {
  const [, before, query, fragment] = /^([^?#]*)(?:\?([^#]*))?(#.*)?$/s.exec(link) ?? [];
  if (query === undefined) return link;
  const parameters = query.split('&').filter((parameter) => !kTracking.test(parameter.split('=')[0]));
  return `${before}${parameters.length > 0 ? `?${parameters.join('&')}` : ''}${fragment ?? ''}`;
}

/** @param {string} link @returns {Advice[]} */
function adviseLink(link) {
  /** @type {Advice[]} */ const advice = [];
  if (/\s/.test(link)) {
    return [
      {
        severity: 'warning',
        key: 'code.link.spaces',
        fixed: link.replace(/\s+/g, '%20'),
        fixKey: 'code.link.encodeSpaces',
      },
    ];
  }
  const parts = splitWebAddress(link);
  if (!parts || !URL.canParse(link) || !(parts.host.includes('.') || /^(localhost|\[)/i.test(parts.host))) {
    return [{ severity: 'warning', key: 'code.link.wrong' }];
  }
  if (/\P{ASCII}/u.test(parts.host)) {
    const ascii = asciiHost(parts.host);
    if (ascii) {
      advice.push({
        severity: 'note',
        key: 'code.link.idn',
        values: { host: ascii },
        fixed: `${parts.scheme}${ascii}${/:\d+$/.exec(parts.host)?.[0] ?? ''}${parts.rest}`,
        fixKey: 'code.link.toAscii',
      });
    }
  }
  const clean = withoutTracking(link);
  if (clean !== link) {
    advice.push({
      severity: link.length > kLongLink ? 'warning' : 'note',
      key: 'code.link.tracking',
      values: { count: link.length - clean.length },
      fixed: clean,
      fixKey: 'code.link.dropTracking',
    });
  }
  return advice;
}

/**
 * Returns advice on a text; none if it is no link.
 * @param {string} text
 * @returns {Advice[]}
 */
export function adviseText(text) {
  const trimmed = text.trim();
  if (kWebAddress.test(trimmed)) {
    if (trimmed !== text)
      return [{ severity: 'warning', key: 'code.link.ends', fixed: trimmed, fixKey: 'code.link.trim' }];
    return adviseLink(text);
  }
  if (kBareAddress.test(trimmed) && !kFileEnding.test(trimmed)) {
    return [
      { severity: 'warning', key: 'code.link.noScheme', fixed: withScheme(trimmed), fixKey: 'code.link.addScheme' },
    ];
  }
  return [];
}

/**
 * Returns other forms of a link that may need a smaller symbol, the safest first. Scheme and host mean the same in
 * capitals [RFC 3986, 6.2.2.1], which take fewer bits. An empty path means the same as a lone slash [6.2.3].
 * @param {string} link
 * @returns {{ text: string, key: Key, same: boolean }[]}  `same`: the form always opens the same page
 */
export function shorterForms(link) {
  const parts = splitWebAddress(link);
  if (!parts || /\s/.test(link) || /\P{ASCII}/u.test(parts.host) || parts.host.includes('@')) return [];
  const short = (/** @type {string} */ host) =>
    `${parts.scheme}${host}`.toUpperCase() + (parts.rest === '/' ? '' : parts.rest);
  const withoutWww = parts.host.replace(/^www\.(?=[^.]+\.)/i, '');
  /** @type {{ text: string, key: Key, same: boolean }[]} */
  const forms = [{ text: short(parts.host), key: 'code.shorter.capitals', same: true }];
  if (withoutWww !== parts.host) forms.push({ text: short(withoutWww), key: 'code.shorter.www', same: false });
  const jump = parts.rest.indexOf('#:~:text=');
  if (jump >= 0)
    forms.push({
      text: link.slice(0, link.length - parts.rest.length + jump),
      key: 'code.shorter.highlight',
      same: false,
    });
  return forms.filter(({ text }) => text !== link);
}
