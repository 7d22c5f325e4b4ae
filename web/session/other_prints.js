// SPDX-License-Identifier: GPL-3.0-or-later
// Which other ways of printing are worth a try: what costs least first.
import { kProcesses, kSettings } from '../generated/settings.js';

/** @typedef {import('../engine/types.js').PrintChange} PrintChange */

/** How the verdict says that a code faces in these poses. @type {Record<string, string>} */
const kFacing = { 'code-up': 'facing-up', 'code-upright': 'facing-aside' };

/**
 * The other poses, then the processes of finer layers, the coarsest of them first.
 * @param {import('../storage/last_work.js').Values} values  of the controls, carved with
 * @param {string | undefined} facing  how the code faces as it was printed, in the verdict's words
 * @returns {PrintChange[]}
 */
export function otherPrints({ process, 'build-up': pose, layer }, facing) {
  const isOther = (/** @type {string} */ one) => one !== pose && (facing === undefined || kFacing[one] !== facing);
  const poses = (kSettings.buildUp.choices ?? []).filter(isOther);
  const finer = Object.entries(kProcesses).filter(([name, { layerMm }]) => name !== process && name !== 'powder' && layerMm < Number(layer))
    .sort(([, a], [, b]) => b.layerMm - a.layerMm);
  return [...poses.map((buildUp) => ({ buildUp })), ...finer.map(([name]) => ({ process: name }))];
}
