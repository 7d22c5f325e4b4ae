// SPDX-License-Identifier: GPL-3.0-or-later
// The npm package in browsers and in their workers.
import { Planner } from './planner.js';

export { EngineFailure as EngineError } from '../engine/engine_error.js';
export { Engine, engrave } from './engine.js';
export { hint, sentence } from './words.js';

/**
 * Loads the part that needs no worker.
 * @returns {Promise<Planner>}
 */
export const loadPlanner = () => Planner.load();
