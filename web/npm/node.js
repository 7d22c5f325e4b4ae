// SPDX-License-Identifier: GPL-3.0-or-later
// The npm package in Node. An engine needs WebGL 2, which Node lacks, so `engrave` and `Engine.start` reject with the
// code `no-webgl2`.
import { readFile } from 'node:fs/promises';
import { Planner } from './planner.js';

export { EngineFailure as EngineError } from '../engine/engine_error.js';
export { Engine, engrave } from './engine.js';

/**
 * Loads the part that needs no graphics. Unlike `fetch`, it reads the module from the disk.
 * @returns {Promise<Planner>}
 */
export const loadPlanner = () => Planner.load(async (url) => WebAssembly.compile(await readFile(new URL(url))));
