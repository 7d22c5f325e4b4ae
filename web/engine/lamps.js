// SPDX-License-Identifier: GPL-3.0-or-later
// Lamps in addition to the sky, in the syntax of the page and the command (core/settings/setting_text.h): one
// AZIMUTH,ELEVATION[,STRENGTH] per lamp, separated by spaces.

/** @typedef {{ azimuthDeg: number, elevationDeg: number, strength?: number }} Lamp */

const kParts = /** @type {const} */ (['azimuthDeg', 'elevationDeg', 'strength']);
const kNumber = /^[-+]?(\d+\.?\d*|\.\d+)$/;

/**
 * Parses lamps.
 * @param {string} text
 * @returns {Lamp[] | undefined}  [] for an empty text; undefined on a syntax error
 */
export function lampsFrom(text) {
  const lamps = text
    .trim()
    .replace(/\s*,\s*/g, ',')
    .split(/\s+/)
    .filter((part) => part !== '')
    .map((part) => part.split(','));
  if (
    lamps.some(
      (numbers) =>
        numbers.length < 2 || numbers.length > kParts.length || !numbers.every((number) => kNumber.test(number)),
    )
  )
    return undefined;
  return lamps.map(
    (numbers) => /** @type {Lamp} */ (Object.fromEntries(numbers.map((number, at) => [kParts[at], Number(number)]))),
  );
}

/** Formats lamps as `lampsFrom` reads them. @param {readonly Lamp[]} lamps */
export const lampsText = (lamps) => lamps.map((lamp) => kParts.flatMap((part) => lamp[part] ?? []).join(',')).join(' ');

/** Tells whether a value from a file is a list of lamps. @param {unknown} value @returns {value is Lamp[]} */
export const areLamps = (value) =>
  Array.isArray(value) &&
  value.every(
    (lamp) =>
      typeof lamp === 'object' &&
      lamp !== null &&
      Object.entries(lamp).every(
        ([part, number]) => kParts.some((known) => known === part) && Number.isFinite(number),
      ) &&
      Number.isFinite(lamp.azimuthDeg) &&
      Number.isFinite(lamp.elevationDeg),
  );
