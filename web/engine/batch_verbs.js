// SPDX-License-Identifier: GPL-3.0-or-later
// The engine's verbs for batches: plan, manifest and plates.
import { parseAnswer } from './answers.js';
import { EngineFailure, internal } from './engine_error.js';
import { message } from './message.js';

/**
 * Makes the verbs that plan a batch and write its manifest.
 * @param {() => import('./types.js').PlannedBatch} makePlanned  called once, on first use
 */
export function makePlanVerbs(makePlanned) {
  /** @type {import('./types.js').PlannedBatch | undefined} */ let batch;
  const planned = () => (batch ??= makePlanned());
  return {
    /** @param {Uint8Array} list @param {import('./types.js').WantedBatch} wanted */
    planBatch: (list, wanted) => parseAnswer(planned().plan(list, JSON.stringify(wanted))),
    /** @param {number} from @param {number} count */
    batchRows: (from, count) => parseAnswer(planned().rows(from, count)).rows,
    /** @param {number} index */
    batchRow: (index) => parseAnswer(planned().row(index)).row,
    /** @param {number} index @param {{ centre: number[], others: string }} placed */
    batchRowToHash: (index, placed) => parseAnswer(planned().toHash(index, JSON.stringify(placed))).text,
    /** @param {import('./types.js').ManifestEntry} entry */
    manifestLine: (entry) => parseAnswer(planned().manifestLine(JSON.stringify(entry))).line,
    /** @param {string} lines @param {boolean} withHeader */
    manifestCsv: (lines, withHeader) => parseAnswer(planned().manifestCsv(lines, withHeader)).csv,
  };
}

/**
 * Makes the batch verbs of a host.
 * @param {() => import('./types.js').Engine} engine
 * @param {() => import('./types.js').PlannedBatch} makePlanned  called once, on first use
 */
export function makeBatchVerbs(engine, makePlanned) {
  return {
    ...makePlanVerbs(makePlanned),
    /** @param {number} copies */
    startPlate: (copies) => void parseAnswer(engine().startPlate(copies)),
    /** @param {number} place @param {string} id */
    addToPlate: (place, id) => void parseAnswer(engine().addToPlate(place, id)),
    /** @param {string} title */
    exportPlate: (title) => {
      const bytes = engine().exportPlate(title);
      if (bytes.length > 0) return bytes.slice();
      throw new EngineFailure(internal(message('model-not-written', { format: { term: '3MF' } })));
    },
    /** @param {number} totalMs */
    describeRow: (totalMs) => parseAnswer(engine().describeRow(totalMs)),
  };
}
