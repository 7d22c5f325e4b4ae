// SPDX-License-Identifier: GPL-3.0-or-later
// Escapes the special characters of each format.

const encoder = new TextEncoder();

/** @param {string} text */
export const utf8Length = (text) => encoder.encode(text).length;

/** Puts a backslash before each of these characters. @param {string} text @param {RegExp} special */
const escaped = (text, special) => text.replace(special, '\\$&');

/** @param {string} text */
const onOneLine = (text) => text.replace(/\s*[\r\n]+\s*/g, ' ');

/** Escapes a value of WIFI:, which is a single line. @param {string} text */
export const escapeWifi = (text) => escaped(onOneLine(text), /[\\;,":]/g);

/** Escapes a value of MECARD:, which is a single line. @param {string} text */
export const escapeMeCard = (text) => escaped(onOneLine(text), /[\\;,:]/g);

/** Escapes a text value of vCard 3.0 [RFC 2426, 4] and of iCalendar [RFC 5545, 3.3.11]. @param {string} text */
export const escapeText = (text) => escaped(text, /[\\;,]/g).replace(/\r\n|\r|\n/g, '\\n');

const kLineOctets = 75;

/**
 * Returns a content line with its line break. Folds long lines, but never within a character
 * [RFC 2425, 5.8.1; RFC 5545, 3.1].
 * @param {string} line
 */
export function contentLine(line) {
  let folded = '',
    octets = 0;
  for (const character of line) {
    const more = utf8Length(character);
    if (octets + more > kLineOctets) {
      folded += '\r\n ';
      octets = 1;
    }
    folded += character;
    octets += more;
  }
  return `${folded}\r\n`;
}

/** @param {string[]} lines */
export const contentLines = (lines) => lines.map(contentLine).join('').replace(/\r\n$/, '');

/** Escapes a value within a URI, where line breaks are CRLF [RFC 6068, 5]. @param {string} text */
export const escapeUri = (text) =>
  encodeURIComponent(text.replace(/\r\n|\r|\n/g, '\r\n')).replace(
    /[!'()*]/g,
    (character) => `%${character.charCodeAt(0).toString(16).toUpperCase()}`,
  );
