// SPDX-License-Identifier: GPL-3.0-or-later
// Which other ways of printing are worth a try: what costs least first.
import { kProcesses, kSettings } from '../generated/settings.js';

/** @typedef {import('../engine/types.js').PrintChange} PrintChange */

/** The angle between the code's normal and the printer's vertical that these poses make. @type {Record<string, number>} */
const kFacingDeg = { 'code-up': 0, 'code-upright': 90 };
const kAlikeDeg = 15;

/**
 * The other poses, then the processes of finer layers, the coarsest of them first.
 * @param {import('../storage/last_work.js').Values} values  of the controls, carved with
 * @param {number} facingDeg  how the code faces as it was printed
 * @returns {PrintChange[]}
 */
export function otherPrints({ process, 'build-up': pose, layer }, facingDeg) {
  const isOther = (/** @type {string} */ one) => one !== pose && !(Math.abs(kFacingDeg[one] - facingDeg) <= kAlikeDeg);
  const poses = (kSettings.buildUp.choices ?? []).filter(isOther);
  const finer = Object.entries(kProcesses).filter(([name, { layerMm }]) => name !== process && name !== 'powder' && layerMm < Number(layer))
    .sort(([, a], [, b]) => b.layerMm - a.layerMm);
  return [...poses.map((buildUp) => ({ buildUp })), ...finer.map(([name]) => ({ process: name }))];
}
