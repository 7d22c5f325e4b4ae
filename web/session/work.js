// SPDX-License-Identifier: GPL-3.0-or-later
// All that decides what is carved.

/** @typedef {import('./model_session.js').Source} Source */
/** @typedef {[number, number, number]} Point */
/** @typedef {{ source: Source | undefined, text: string, values: import('../ui/settings_form.js').Values,
 *   centreMm: Point | undefined, centreIsGuess: boolean }} Work */

/** Whether it is the same file, read the same way. @param {Source | undefined} a @param {Source | undefined} b */
export const sameModel = (a, b) => a?.bytes === b?.bytes && a?.scaleToMm === b?.scaleToMm;

/** @param {Point | undefined} a @param {Point | undefined} b */
export const sameCentre = (a, b) => a?.join() === b?.join();

/** @param {Work} a @param {Work} b */
export const sameWork = (a, b) => sameModel(a.source, b.source) && a.source?.upAxis === b.source?.upAxis && a.text === b.text &&
  sameCentre(a.centreMm, b.centreMm) && Object.entries(a.values).every(([id, value]) => b.values[id] === value);
