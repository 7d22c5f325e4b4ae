// SPDX-License-Identifier: GPL-3.0-or-later
// Tries from how far, how tilted and how blurred a carved code decodes.
import { readsAny } from '../decoder/reader.js';

/**
 * @param {import('../engine/client.js').EngineClient} client
 * @param {Parameters<import('../ui/grades_panel.js').ViewTrier>} request  report, progress and cancellation
 * @returns {Promise<import('../engine/types.js').ViewTrials | undefined>}  undefined: cancelled
 */
export async function tryViews(client, ...[report, onTrial, signal]) {
  for (let all = await client.startViewTrials(), tried = 0; ;) {
    onTrial(tried, all);
    const read = await readsAny(await client.pictures('view-trial'), report.text);
    if (signal.aborted) return undefined;
    const progress = await client.noteViewTrial(read);
    if (progress.done) return progress.views;
    ({ tried, all } = progress);
  }
}
