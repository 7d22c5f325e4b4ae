// SPDX-License-Identifier: GPL-3.0-or-later
// Settings files: all inputs of a carving, with a reference to the model but without the model itself.
import { EngineFailure } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { kSettings } from '../generated/settings.js';
import { excerpt, isPoint, settingProblem } from '../settings/setting_problem.js';

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

/** @param {unknown} value @returns {value is Record<string, unknown>} */
const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/** @param {Record<string, unknown>} settings @param {readonly SettingKey[]} keys  of a file */
function checkSettings(settings, keys) {
  const unknown = Object.keys(settings).find((name) => !keys.includes(/** @type {SettingKey} */ (name)));
  if (unknown !== undefined) refuseFile(message('settings-unknown', { name: { term: excerpt(unknown) } }));
  if (settings.text === undefined) refuseFile(message('settings-missing', { name: { term: 'text' } }));
  for (const name of keys) {
    const problem = settings[name] !== undefined && settingProblem(name, settings[name]);
    if (problem) throw new EngineFailure({ kind: 'BadInput', ...problem });
  }
}

/** @param {unknown} model @returns {ModelChoice} */
function checkModel(model) {
  if (!isObject(model)) refuseFile(message('settings-wrong-model', { value: { term: excerpt(model) } }));
  const { file, sample, scaleToMm, upAxis, centreMm } = model;
  if (typeof file !== 'string' || (sample !== undefined && typeof sample !== 'string'))
    refuseFile(message('settings-wrong-model', { value: { term: excerpt(file) } }));
  if (typeof scaleToMm !== 'number' || !(scaleToMm >= 1e-6 && scaleToMm <= 1e6))
    refuseFile(
      message('setting-out-of-range', {
        setting: { setting: 'scale' },
        value: { term: excerpt(scaleToMm) },
        min: { number: 1e-6 },
        max: { number: 1e6 },
      }),
    );
  if (upAxis !== 'y' && upAxis !== 'z')
    refuseFile(
      message('setting-no-choice', {
        setting: { setting: 'upAxis' },
        found: { term: excerpt(upAxis) },
        choices: { term: 'y, z' },
      }),
    );
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
        known: { index: kVersion },
      }),
    );
  if (!isObject(content.settings)) refuseFile(message('settings-missing', { name: { term: 'settings' } }));
  checkSettings(content.settings, fileKeys(controls));
  const settings = /** @type {Settings} */ (/** @type {unknown} */ (content.settings));
  return { settings, ...(content.model === undefined ? {} : { model: checkModel(content.model) }) };
}
