// SPDX-License-Identifier: GPL-3.0-or-later
// What a person needs to know of a carving, from its report: does it read, does it print, is it solid.

/** @typedef {import('../engine/types.js').Report} Report */
/** @typedef {import('../decoder/reader.js').Reading} Reading */
/** @typedef {'good' | 'barely' | 'bad'} Level */
/** @typedef {{ reads: Level, prints: Level, solid: Level, weak: boolean }} Verdict  `weak`: a verifier's grade would be F */

/** Share of the tries that must succeed for a code to count as read, as in the core's verification. */
export const kReadShare = 0.4;
const kLeastGrade = 1;  // D

/** @param {Report} report @param {Reading} reading @returns {Verdict} */
export function verdictOf(report, reading) {
  const { mesh, verification, text } = report;
  const right = reading.text === text;
  const weak = verification.iso29158.overall < kLeastGrade;
  const sure = reading.reads >= kReadShare * reading.tries && !weak;
  const solid = mesh.closed && mesh.manifold && mesh.selfIntersections === 0;
  return {
    reads: !right ? 'bad' : sure ? 'good' : 'barely',
    prints: verification.printability.length === 0 ? 'good' : 'barely',
    solid: solid ? 'good' : 'bad',
    weak,
  };
}
