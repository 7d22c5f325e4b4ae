// SPDX-License-Identifier: GPL-3.0-or-later
// The npm package in browsers and in their workers.
import { Planner } from './planner.js';

export { EngineFailure as EngineError } from '../engine/engine_error.js';
export { Engine, engrave } from './engine.js';
export { hint, languages, loadLanguage, sentence } from './words.js';

/** @typedef {import('./arguments.js').Bytes} Bytes */
/** @typedef {import('./arguments.js').Format} Format */
/** @typedef {import('./engine.js').Settings} Settings */
/** @typedef {import('./engine.js').Point} Point */
/** @typedef {import('./engine.js').Progress} Progress */
/** @typedef {import('./engine.js').JobOptions} JobOptions */
/** @typedef {import('./engine.js').EngraveOptions} EngraveOptions */
/** @typedef {import('./engine.js').Engraved} Engraved */
/** @typedef {import('./planner.js').BatchRequest} BatchRequest */
/** @typedef {import('../engine/types.js').Message} Message */
/** @typedef {import('../engine/types.js').Finding} Finding */
/** @typedef {import('../engine/types.js').ModelInfo} ModelInfo */
/** @typedef {import('../engine/types.js').SymbolFacts} SymbolFacts */
/** @typedef {import('../engine/types.js').Spots} Spots */
/** @typedef {Spots['spots'][number]} Spot */
/** @typedef {import('../engine/types.js').Placement} Placement */
/** @typedef {import('../engine/types.js').Verdict} Verdict */
/** @typedef {import('../engine/types.js').Aspect} Aspect */
/** @typedef {import('../engine/types.js').Remedy} Remedy */
/** @typedef {import('../engine/types.js').Report} Report */
/** @typedef {import('../engine/types.js').NamedFile} NamedFile */
/** @typedef {import('../engine/types.js').BatchPlan} BatchPlan */
/** @typedef {import('../engine/types.js').BatchRow} BatchRow */

/**
 * Loads the part that needs no worker.
 * @returns {Promise<Planner>}
 */
export const loadPlanner = () => Planner.load();
