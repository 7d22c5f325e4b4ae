// SPDX-License-Identifier: GPL-3.0-or-later
// The npm package in Node. An engine has no graphics there: the processor does all the work.
import { readFile } from 'node:fs/promises';
import { NodeWorker } from './node_worker.js';
import { Planner } from './planner.js';

export { EngineFailure as EngineError } from '../engine/engine_error.js';
export { Engine, engrave } from './engine.js';
export { hint, languages, loadLanguage, sentence } from './words.js';

/** @type {{ Worker?: unknown }} */ (globalThis).Worker ??= NodeWorker;

/**
 * Loads the part that needs no worker. Unlike `fetch`, it reads the module from the disk.
 * @returns {Promise<Planner>}
 */
export const loadPlanner = () => Planner.load(async (url) => WebAssembly.compile(await readFile(new URL(url))));
