// SPDX-License-Identifier: GPL-3.0-or-later
// The work: all inputs of the carving. Also values computed from a work, and changes that make the next one.
import { proposedChange, sameSettings, settingsAfter } from '../settings/work_settings.js';

/** @typedef {import('./model_session.js').Source} Source */
/** @typedef {import('../settings/work_settings.js').WorkSettings} WorkSettings */
/** @typedef {[number, number, number]} Point */
/** @typedef {{ source: Source | undefined, text: string, settings: WorkSettings,
 *   centreMm: Point | undefined, centreIsGuess: boolean, batch?: import('../storage/last_work.js').BatchInput }} Work
 *   `batch`: absent for a single code; the same object until it changes */

/** The work before anything is chosen. @type {Work} */
export const kNoWork = { source: undefined, text: '', settings: {}, centreMm: undefined, centreIsGuess: false };

/**
 * Tells whether two sources are the same file in the same unit.
 * @param {Source | undefined} a
 * @param {Source | undefined} b
 */
export const sameModel = (a, b) => a?.bytes === b?.bytes && a?.scaleToMm === b?.scaleToMm;

/** @param {Point | undefined} a @param {Point | undefined} b */
export const sameCentre = (a, b) => a?.join() === b?.join();

/** Returns true if only the place of the code may differ. @param {Work} a @param {Work} b */
export const sameButPlace = (a, b) =>
  sameModel(a.source, b.source) &&
  a.source?.upAxis === b.source?.upAxis &&
  a.text === b.text &&
  a.batch === b.batch &&
  sameSettings(a.settings, b.settings);

/** @param {Work} a @param {Work} b */
export const sameWork = (a, b) => sameButPlace(a, b) && sameCentre(a.centreMm, b.centreMm);

/** Returns the centre chosen by the user, which is stored with the model. @param {Work} work */
export const chosenCentre = ({ centreMm, centreIsGuess }) => (centreIsGuess ? undefined : centreMm);

/**
 * Returns the change that centres the code.
 * @param {Point | undefined} centreMm  undefined: not chosen yet
 * @param {boolean} [isGuess]  the module proposed it; then it is no error if the code does not fit there
 * @returns {Pick<Work, 'centreMm' | 'centreIsGuess'>}
 */
export const centredAt = (centreMm, isGuess = false) => ({
  centreMm,
  centreIsGuess: isGuess && centreMm !== undefined,
});

/**
 * Returns the work as it is stored for the next visit.
 * @param {Work} work
 * @returns {import('../storage/last_work.js').Work | undefined}  undefined while there is no model
 */
export function storedWork(work) {
  const { source, text, settings, batch } = work;
  if (!source) return undefined;
  const { bytes, sampleId, fileName, scaleToMm, upAxis } = source;
  const place = { fileName, scaleToMm, upAxis, centreMm: chosenCentre(work) };
  return { ...(sampleId ? { sampleId } : { bytes }), ...place, text, settings, ...(batch && { batch }) };
}

/**
 * Returns the change of the settings by the code's handles.
 * @param {{ rotateDeg?: number, symbolMm?: number }} change
 * @param {WorkSettings} now
 * @returns {WorkSettings}
 */
export function changeByHandles({ rotateDeg, symbolMm }, now) {
  if (symbolMm !== undefined) return { size: symbolMm, ...(rotateDeg !== undefined && { rotateDeg }) };
  if (rotateDeg === undefined) return {};
  return { rotateDeg, ...(now.size === 'best' && { size: 'oriented' }) }; // 'best' would rotate it back
}

/**
 * Returns text and settings with the changes that the engine proposes.
 * @param {Pick<Work, 'text' | 'settings'>} work
 * @param {readonly import('../engine/types.js').SettingChange[]} changes
 */
export function withChanges({ text, settings }, changes) {
  const isOfText = (/** @type {import('../engine/types.js').SettingChange} */ { setting }) => setting === 'text';
  return {
    text: changes.find(isOfText)?.value ?? text,
    settings: changes
      .filter((change) => !isOfText(change))
      .reduce((before, change) => settingsAfter(before, proposedChange(change)), settings),
  };
}
