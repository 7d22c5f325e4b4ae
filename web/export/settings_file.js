// SPDX-License-Identifier: GPL-3.0-or-later
// Settings files: all inputs of a carving, with a reference to the model but without the model itself.
import { EngineFailure } from '../engine/engine_error.js';
import { areLamps } from '../engine/lamps.js';
import { message } from '../engine/message.js';
import { kSettings } from '../generated/settings.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {import('../engine/types.js').UpAxis} UpAxis */
/** @typedef {import('../generated/settings.js').SettingKey} SettingKey */
/** @typedef {[number, number, number]} Point */

/**
 * @typedef {object} ModelChoice
 * @property {string} file           file name
 * @property {string} [sample]       id, if the model is a sample
 * @property {number} scaleToMm
 * @property {UpAxis} upAxis
 * @property {Point} [centreMm]      of the code
 */

/** @typedef {{ settings: Settings, model?: ModelChoice }} SettingsFile */

const kKind = 'qrelief-settings';
const kVersion = 1;
const kMostBytes = 1 << 20;
const kKeys = /** @type {SettingKey[]} */ (Object.keys(kSettings));

/**
 * Returns the keys in a file: the text and all settings with a control.
 * @param {readonly SettingKey[]} controls
 * @returns {SettingKey[]}
 */
export const fileKeys = (controls) => kKeys.filter((key) => key === 'text' || controls.includes(key));

/** @param {SettingsFile} file */
export const writeSettingsFile = ({ settings, model }) =>
  `${JSON.stringify({ kind: kKind, version: kVersion, settings, ...(model ? { model } : {}) }, null, 2)}\n`;

/**
 * Tells whether a file may be a settings file rather than a model.
 * @param {{ name: string, type: string }} file
 */
export const looksLikeSettings = ({ name, type }) => /\.json$/i.test(name) || type === 'application/json';

/** @param {import('../engine/message.js').Message} why @returns {never} */
function refuseFile(why) {
  throw new EngineFailure({ kind: 'BadInput', ...message('settings-file-refused', { why: { cause: why } }) });
}

/** Formats a value for a message, 40 characters at most. @param {unknown} value */
function excerpt(value) {
  const json = JSON.stringify(value) ?? 'undefined';
  return json.length > 40 ? `${json.slice(0, 39)}…` : json;
}

/** @param {unknown} value @returns {value is Record<string, unknown>} */
const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/** @param {unknown} value @returns {value is number} */
const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);

/** @param {unknown} value @returns {value is Point} */
const isPoint = (value) => Array.isArray(value) && value.length === 3 && value.every(isNumber);

/** @typedef {(why: import('../engine/message.js').Message) => never} Refuse */

/** @param {string} name @param {unknown} value @param {readonly [number, number]} range @param {Refuse} refuse */
function checkNumber(name, value, [from, to], refuse) {
  if (!isNumber(value) || value < from || value > to)
    refuse(
      message('settings-wrong-number', {
        name: { term: name },
        from: { number: from },
        to: { number: to },
        value: { term: excerpt(value) },
      }),
    );
}

/** @param {string} name @param {unknown} value @param {readonly string[]} choices @param {Refuse} refuse */
function checkChoice(name, value, choices, refuse) {
  if (!choices.includes(/** @type {string} */ (value)))
    refuse(
      message('settings-wrong-choice', {
        name: { term: name },
        choices: { term: choices.join(', ') },
        value: { term: excerpt(value) },
      }),
    );
}

/**
 * Checks the value of a setting from a file or an address.
 * @param {SettingKey} name
 * @param {unknown} value
 * @param {Refuse} [refuse]  throws an error that says why
 */
export function checkSetting(name, value, refuse = refuseFile) {
  const { kind, choices = [], min = 0, max = 0 } = kSettings[name];
  if (kind === 'text') {
    if (typeof value !== 'string')
      refuse(message('settings-wrong-text', { name: { term: name }, value: { term: excerpt(value) } }));
  } else if (kind === 'switch') {
    if (typeof value !== 'boolean')
      refuse(message('settings-wrong-switch', { name: { term: name }, value: { term: excerpt(value) } }));
  } else if (kind === 'lamps') {
    if (!areLamps(value))
      refuse(message('settings-wrong-lamps', { name: { term: name }, value: { term: excerpt(value) } }));
  } else if (kind === 'number' || (kind === 'choice-or-number' && isNumber(value))) {
    checkNumber(name, value, [min, max], refuse);
  } else {
    checkChoice(name, value, choices, refuse);
  }
}

/** @param {Record<string, unknown>} settings @param {readonly SettingKey[]} keys  of a file */
function checkSettings(settings, keys) {
  const unknown = Object.keys(settings).find((name) => !keys.includes(/** @type {SettingKey} */ (name)));
  if (unknown !== undefined) refuseFile(message('settings-unknown', { name: { term: excerpt(unknown) } }));
  if (settings.text === undefined) refuseFile(message('settings-missing', { name: { term: 'text' } }));
  for (const name of keys) if (settings[name] !== undefined) checkSetting(name, settings[name]);
}

/** @param {unknown} model @returns {ModelChoice} */
function checkModel(model) {
  if (!isObject(model)) refuseFile(message('settings-wrong-model', { value: { term: excerpt(model) } }));
  const { file, sample, scaleToMm, upAxis, centreMm } = model;
  if (typeof file !== 'string' || (sample !== undefined && typeof sample !== 'string'))
    refuseFile(message('settings-wrong-model', { value: { term: excerpt(file) } }));
  checkNumber('scaleToMm', scaleToMm, [1e-6, 1e6], refuseFile);
  checkChoice('upAxis', upAxis, ['y', 'z'], refuseFile);
  if (centreMm !== undefined && !isPoint(centreMm))
    refuseFile(message('settings-wrong-centre', { value: { term: excerpt(centreMm) } }));
  return /** @type {ModelChoice} */ ({
    file,
    scaleToMm,
    upAxis,
    ...(sample === undefined ? {} : { sample }),
    ...(centreMm ? { centreMm } : {}),
  });
}

/** @param {string} json @param {string} name */
function parse(json, name) {
  try {
    return JSON.parse(json);
  } catch {
    return refuseFile(message('settings-no-json', { file: { quoted: name } }));
  }
}

/**
 * Reads and checks a settings file.
 * @param {string} json
 * @param {string} name  of the file, for messages
 * @param {readonly SettingKey[]} controls  settings that have a control
 * @returns {SettingsFile}  the defaults apply where a setting is missing
 * @throws {EngineFailure} naming the wrong setting; then do not use any part of the file
 */
export function readSettingsFile(json, name, controls) {
  if (json.length > kMostBytes) refuseFile(message('settings-absent', { file: { quoted: name } }));
  const content = parse(json.replace(/^\ufeff/, ''), name);
  if (isObject(content) && typeof content.qrelief === 'string')
    refuseFile(message('settings-are-report', { file: { quoted: name } }));
  if (!isObject(content) || content.kind !== kKind) refuseFile(message('settings-absent', { file: { quoted: name } }));
  if (content.version !== kVersion)
    refuseFile(
      message('settings-other-version', {
        file: { quoted: name },
        version: { term: excerpt(content.version) },
        known: { count: kVersion },
      }),
    );
  if (!isObject(content.settings)) refuseFile(message('settings-missing', { name: { term: 'settings' } }));
  checkSettings(content.settings, fileKeys(controls));
  const settings = /** @type {Settings} */ (/** @type {unknown} */ (content.settings));
  return { settings, ...(content.model === undefined ? {} : { model: checkModel(content.model) }) };
}
