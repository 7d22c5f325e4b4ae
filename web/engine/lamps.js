// SPDX-License-Identifier: GPL-3.0-or-later
// Lamps beside the sky as they are typed, here and for the command (core/settings/setting_text.h): of each
// AZIMUTH,ELEVATION,STRENGTH, the strength may be left out; several stand apart.

/** @typedef {{ azimuthDeg: number, elevationDeg: number, strength?: number }} Lamp */

const kParts = /** @type {const} */ (['azimuthDeg', 'elevationDeg', 'strength']);
const kNumber = /^[-+]?(\d+\.?\d*|\.\d+)$/;

/** @param {string} text @returns {Lamp[] | undefined}  none of an empty text; undefined if it is something else */
export function lampsFrom(text) {
  const lamps = text.trim().replace(/\s*,\s*/g, ',').split(/\s+/).filter((part) => part !== '').map((part) => part.split(','));
  if (lamps.some((numbers) => numbers.length < 2 || numbers.length > kParts.length || !numbers.every((number) => kNumber.test(number)))) return undefined;
  return lamps.map((numbers) => /** @type {Lamp} */ (Object.fromEntries(numbers.map((number, at) => [kParts[at], Number(number)]))));
}

/** The same way back. @param {readonly Lamp[]} lamps */
export const lampsText = (lamps) => lamps.map((lamp) => kParts.flatMap((part) => lamp[part] ?? []).join(',')).join(' ');

/** Whether a value of a file is lamps. @param {unknown} value @returns {value is Lamp[]} */
export const areLamps = (value) => Array.isArray(value) && value.every((lamp) => typeof lamp === 'object' && lamp !== null
  && Object.entries(lamp).every(([part, number]) => kParts.some((known) => known === part) && Number.isFinite(number))
  && Number.isFinite(lamp.azimuthDeg) && Number.isFinite(lamp.elevationDeg));
