// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the values of settings by the core's table, with the core's messages (core/settings/check_settings.cpp): whatever
// sets a setting, an unsuitable value is refused in the same words.
import { areLamps, lampsText } from '../engine/lamps.js';
import { message } from '../engine/message.js';
import { kSettings } from '../generated/settings.js';

/** @typedef {import('../engine/lamps.js').Lamp} Lamp */
/** @typedef {import('../engine/message.js').Message} Message */
/** @typedef {import('../engine/message.js').Value} Value */
/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */
/** @typedef {import('../generated/settings.js').UnitName} UnitName */

const kMostShown = 40; // characters of a value in a message

/**
 * Says why a setting cannot have a value.
 * @param {SettingKey} key
 * @param {unknown} value  NaN: a number that is missing
 * @returns {Message | undefined}  undefined: it can
 */
export function settingProblem(key, value) {
  const { kind, choices = [] } = kSettings[key];
  if (typeof value === 'number' && (kind === 'number' || kind === 'choice-or-number')) return numberProblem(key, value);
  if (kind === 'lamps' && areLamps(value)) return lampsProblem(key, value);
  if (kind === 'mask' && isMask(value)) return undefined;
  if ((kind === 'vector' || kind === 'choice-or-vector') && isPoint(value)) return vectorProblem(key, value);
  if (kind === 'text' ? typeof value === 'string' : choices.includes(/** @type {string} */ (value))) return undefined;
  return kind === 'switch' && typeof value === 'boolean' ? undefined : wrongKind(key, value);
}

/** Tells whether a value is a mask: five rows of five, with a 0 and a 1. @param {unknown} value */
const isMask = (value) =>
  typeof value === 'string' && /^[01]{5}(\/[01]{5}){4}$/.test(value) && value.includes('0') && value.includes('1');

/** @param {unknown} value @returns {value is [number, number, number]} */
export const isPoint = (value) => Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);

/** Formats a value of a file for a message. @param {unknown} value */
export function excerpt(value) {
  const json = JSON.stringify(value) ?? 'undefined';
  return json.length > kMostShown ? `${json.slice(0, kMostShown - 1)}…` : json;
}

/** @param {SettingKey} key @param {number} value */
function numberProblem(key, value) {
  const { unit, min = -Infinity, max = Infinity, whole } = kSettings[key];
  const setting = { setting: key };
  if (Number.isNaN(value))
    return message('control-not-a-number', { setting, from: { number: min }, to: { number: max } });
  const problem = rangeProblem(key, unit, value, { min, max });
  if (problem || !whole || Number.isInteger(value)) return problem;
  return message('setting-not-whole', { setting, value: { number: value } });
}

/** @param {SettingKey} key @param {readonly Lamp[]} lamps */
function lampsProblem(key, lamps) {
  const { parts = {}, most = Infinity } = kSettings[key];
  if (lamps.length > most)
    return message('setting-too-many', {
      setting: { setting: key },
      count: { count: lamps.length },
      max: { count: most },
    });
  return lamps
    .flatMap((lamp) => Object.entries(lamp))
    .map(([part, value]) => rangeProblem(key, part.endsWith('Deg') ? 'deg' : undefined, value, parts[part]))
    .find(Boolean);
}

/** @param {SettingKey} key @param {[number, number, number]} vector */
const vectorProblem = (key, vector) =>
  vector.some((part) => part !== 0)
    ? undefined
    : message('setting-no-length', { setting: { setting: key }, vector: { place: vector } });

/** @param {SettingKey} key @param {UnitName | undefined} unit @param {number} value @param {{ min: number, max: number }} range */
function rangeProblem(key, unit, value, { min, max }) {
  if (value >= min && value <= max) return undefined;
  const [given, from, to] = [value, min, max].map((number) => inUnit(unit, number));
  return message('setting-out-of-range', { setting: { setting: key }, value: given, min: from, max: to });
}

/** @param {UnitName | undefined} unit @param {number} number @returns {Value} */
function inUnit(unit, number) {
  if (unit === 'mm') return { lengthMm: number };
  return unit === 'deg' ? { angleDeg: number } : { number };
}

/** @param {SettingKey} key @param {unknown} value */
function wrongKind(key, value) {
  const setting = { setting: key };
  const found = { term: excerpt(value) };
  const choices = { term: (kSettings[key].choices ?? []).join(', ') };
  switch (kSettings[key].kind) {
    case 'text':
      return message('setting-no-text', { setting, found });
    case 'switch':
      return message('setting-no-switch', { setting, found });
    case 'number':
      return message('setting-no-number', { setting, found });
    case 'choice':
      return message('setting-no-choice', { setting, found, choices });
    case 'choice-or-number':
      return message('setting-no-choice-or-number', { setting, found, choices });
    case 'choice-or-vector':
      return message('setting-no-choice-or-vector', { setting, found, choices });
    case 'mask':
      return message('setting-no-mask', { setting, found });
    case 'vector':
      return message('setting-no-vector', { setting, found });
    default:
      return message('setting-no-lamps', { setting, found: unfinished(value) ?? found });
  }
}

/** Returns lamps with missing numbers as their fields show them: "?,40,1". @param {unknown} value @returns {Value | undefined} */
function unfinished(value) {
  const isUnfinished =
    Array.isArray(value) && value.some((lamp) => Object.values(lamp ?? {}).some((part) => Number.isNaN(part)));
  return isUnfinished ? { quoted: lampsText(value).replaceAll('NaN', '?') } : undefined;
}
