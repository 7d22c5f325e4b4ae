// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the module that knows the states of a batch's rows. It runs in the page, apart from the engines, so it
// stays when one of them is replaced.
import { callsOf } from '../engine/module_calls.js';
import { kTrackVerbs } from '../engine/verbs.js';

/** @typedef {import('../engine/verbs.js').Calls<typeof kTrackVerbs>} Tracker */

/** @returns {Promise<Tracker>} */
export async function loadTracker() {
  const { loadModule } = await import('../engine/module.js');
  const module = await loadModule();
  return callsOf(new module.TrackedBatch(), kTrackVerbs);
}
