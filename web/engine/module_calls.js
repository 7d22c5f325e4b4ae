// SPDX-License-Identifier: GPL-3.0-or-later
// Calls the module with JavaScript values, and turns its answers into such.
import { EngineFailure } from './engine_error.js';

/** Returns an argument as the module takes it. @param {unknown} value */
const outbound = (value) => (typeof value === 'object' && !ArrayBuffer.isView(value) ? JSON.stringify(value) : value);

/**
 * Parses an answer of the module.
 * @param {string} json
 * @returns {any}
 * @throws {EngineFailure} if the answer is a failure
 */
function parsed(json) {
  const answer = JSON.parse(json);
  if (answer.ok === false) throw new EngineFailure(answer.error);
  return answer;
}

/**
 * Returns the verbs of an object of the module as functions. They throw EngineFailure.
 * @template {Record<string, import('./verbs.js').Verb<any>>} Rows
 * @param {import('./types.js').ModuleObject} object
 * @param {Rows} rows
 * @returns {import('./verbs.js').Calls<Rows>}
 */
export function callsOf(object, rows) {
  const calls = Object.entries(rows).map(([name, { part }]) => [
    name,
    (/** @type {unknown[]} */ ...given) => {
      const answer = object[name](...given.map(outbound));
      const value = typeof answer === 'string' ? parsed(answer) : answer;
      return part ? value[part] : value;
    },
  ]);
  return Object.fromEntries(calls);
}
