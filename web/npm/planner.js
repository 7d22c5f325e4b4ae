// SPDX-License-Identifier: GPL-3.0-or-later
// Everything of the module that takes no time: models, symbols, and the plans of batches.
import { callsOf } from '../engine/module_calls.js';
import { loadModule } from '../engine/module.js';
import { kBatchVerbs, kFactVerbs } from '../engine/verbs.js';
import { bytesOf, fileNameOf, kModelName } from './arguments.js';

/** @typedef {import('./arguments.js').Bytes} Bytes */
/** @typedef {import('./engine.js').Settings} Settings */
/**
 * Request for a batch, see `planBatch`. `text`, `name`: templates, needed where the list has no such column; `count`:
 * number of rows without a list; `perPlate`: rows per plate; default: one file per row.
 * @typedef {{ settings?: Settings, text?: string, name?: string, count?: number, perPlate?: number }} BatchRequest
 */

/**
 * The verbs run in the thread of the caller. Every failure throws an EngineError; arguments of a wrong kind throw a
 * TypeError.
 */
export class Planner {
  // Private to the language, so that the package's types have no part of them.
  /** @type {import('../engine/verbs.js').Calls<typeof kFactVerbs>} */ #facts;
  /** @type {import('../engine/verbs.js').Calls<typeof kBatchVerbs>} */ #verbs;

  /**
   * Loads a module for the planner.
   * @internal
   * @param {import('../engine/module.js').Compile} [compile]
   * @returns {Promise<Planner>}
   */
  static async load(compile) {
    return new Planner(await loadModule(compile));
  }

  /** Call `loadPlanner` instead. @internal @param {import('../engine/module.js').QReliefModule} module */
  constructor(module) {
    this.#facts = callsOf(new module.Facts(), kFactVerbs);
    this.#verbs = callsOf(new module.PlannedBatch(), kBatchVerbs);
  }

  /**
   * Reads, checks and repairs a model.
   * @param {Bytes} bytes
   * @param {string} [fileName]                 see `Engine.loadModel`
   * @param {{ scaleToMm?: number }} [options]  see `Engine.loadModel`
   * @returns {Omit<import('../engine/types.js').ModelInfo, 'centre'>}
   */
  model(bytes, fileName = kModelName, { scaleToMm = 0 } = {}) {
    return this.#facts.model(bytesOf(bytes), fileNameOf(fileName), scaleToMm);
  }

  /**
   * Describes the symbol that the settings give, or the letters of a text alone.
   * @param {Settings} [settings]
   * @returns {import('../engine/types.js').SymbolFacts | { letters: import('../engine/types.js').LetterFacts }}
   */
  symbol(settings = {}) {
    return this.#facts.symbol(/** @type {import('../engine/types.js').Settings} */ (settings));
  }

  /**
   * Reads a list (CSV or JSON) and checks it as a whole. The other verbs refer to its rows.
   * @param {Bytes} [list]  ignored if there is a `count`
   * @param {BatchRequest} [request]
   * @returns {import('../engine/types.js').BatchPlan}
   */
  planBatch(list, { settings = {}, text = '', name = '', count = 0, perPlate = 0 } = {}) {
    const shared = /** @type {import('../engine/types.js').Settings} */ (settings);
    return this.#verbs.planBatch(count > 0 ? new Uint8Array() : bytesOf(/** @type {Bytes} */ (list)), {
      settings: shared,
      text,
      name,
      count,
      perPlate,
    });
  }

  /**
   * Returns a row of the plan.
   * @param {number} index  from 0
   * @returns {import('../engine/types.js').BatchRow}
   */
  batchRow(index) {
    return this.#verbs.batchRow(index);
  }
}
