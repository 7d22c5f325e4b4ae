// SPDX-License-Identifier: GPL-3.0-or-later
// Makes names for saved files that describe their contents and are valid on every file system.
import { parsePhone } from '../payloads/addresses.js';

const kMostOfText = 32,
  kMostOfModel = 48;
/** ASCII for letters that Unicode does not decompose. */
const kPlainLetters = /** @type {Record<string, string>} */ ({
  ß: 'ss',
  æ: 'ae',
  Æ: 'AE',
  œ: 'oe',
  Œ: 'OE',
  ø: 'o',
  Ø: 'O',
  ł: 'l',
  Ł: 'L',
  đ: 'd',
  Đ: 'D',
  ð: 'd',
  þ: 'th',
  ı: 'i',
});

/**
 * Reduces a text to ASCII letters, digits, dots, hyphens and underscores, without separators at the ends or repeated
 * dots.
 * @param {string} text @param {number} most  characters
 */
export function safePart(text, most) {
  return text
    .replace(/\P{ASCII}/gu, (letter) => kPlainLetters[letter] ?? letter)
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .replace(/[^A-Za-z0-9._-]+/g, '-')
    .replace(/\.{2,}/g, '.')
    .replace(/-{2,}/g, '-')
    .slice(0, most)
    .replace(/^[-._]+|[-._]+$/g, '');
}

/** Returns the value of a line or field without backslashes. @param {string} text @param {RegExp} start */
const valueAfter = (text, start) => {
  const match = start.exec(text);
  if (!match) return '';
  const value = /^(?:\\[^]|[^;\r\n\\])*/.exec(text.slice(match.index + match[0].length))?.[0] ?? '';
  return value.replace(/\\(.)/g, '$1');
};

/**
 * Returns the subject of a code's text in a few characters; never a password.
 * @param {string} text
 */
export function subjectOf(text) {
  const host = /^https?:\/\/(?:[^/?#@]*@)?([^/?#:]+)/i.exec(text)?.[1];
  if (host) return safePart(host.toLowerCase().replace(/^www\./, ''), kMostOfText);
  /** @type {[RegExp, string, () => string][]} */
  const forms = [
    [/^WIFI:/i, 'wifi', () => valueAfter(text, /(?:^WIFI:|;)S:/i).replace(/^"(.*)"$/, '$1')],
    [/^MECARD:/i, 'contact', () => valueAfter(text, /(?:^MECARD:|;)N:/i)],
    [/^BEGIN:VCARD/i, 'contact', () => valueAfter(text, /^FN:/im)],
    [/^BEGIN:V(?:EVENT|CALENDAR)/i, 'event', () => valueAfter(text, /^SUMMARY:/im)],
    [/^mailto:/i, 'email', () => decoded(text.slice(7).split('?')[0])],
    [/^SMSTO:/i, 'sms', () => parsePhone(text.slice(6).split(':')[0])?.dialled ?? ''],
    [/^tel:/i, 'tel', () => text.slice(4)],
    [/^geo:/i, 'place', () => text.slice(4).split('?')[0].replace(',', '_')],
  ];
  const form = forms.find(([start]) => start.test(text));
  if (form) return [form[1], safePart(form[2](), kMostOfText)].filter(Boolean).join('-');
  return safePart(text, kMostOfText);
}

/** @param {string} text */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/**
 * Returns a file name such as `bunny-qr-en.wikipedia.org-31mm.stl`, or `bunny-text-Rev-B-31mm.stl` for a text alone.
 * @param {object} of
 * @param {string} of.modelFile
 * @param {string} of.text        of the code, or the text alone
 * @param {'code' | 'text'} [of.content]
 * @param {number} [of.symbolMm]  absent while unknown
 * @param {string} [of.addition]  distinguishes files of the same carving
 * @param {string} of.extension
 */
export function fileNameOf({ modelFile, text, content = 'code', symbolMm, addition, extension }) {
  const size = symbolMm === undefined ? '' : `${Math.round(symbolMm)}mm`;
  const subject = content === 'text' ? ['text', safePart(text, kMostOfText)] : ['qr', subjectOf(text)];
  const carving = [...subject, size].filter(Boolean).join('-');
  const stem = safePart(modelFile.replace(/\.[^.]*$/, ''), Infinity);
  // A model that we engraved may already be named so.
  const ending = [`-${carving}`, `-${carving}-${addition}`].find((one) => stem.endsWith(one)) ?? '';
  const model = safePart(stem.slice(0, stem.length - ending.length), kMostOfModel) || 'model';
  return `${[model, carving, addition].filter(Boolean).join('-')}.${extension}`;
}

/**
 * Returns the file name of a symbol, such as `qr-en.wikipedia.org.svg`.
 * @param {string} text
 * @param {string} extension
 */
export const symbolFileName = (text, extension) => `${['qr', subjectOf(text)].filter(Boolean).join('-')}.${extension}`;
