// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the module's answers into JavaScript values.
import { EngineFailure } from './engine_error.js';

/**
 * Parses an answer of the module.
 * @param {string} json
 * @returns {any}
 * @throws {EngineFailure} if the answer is a failure
 */
export function parseAnswer(json) {
  const answer = JSON.parse(json);
  if (answer.ok === false || answer.error) throw new EngineFailure(answer.error);
  return answer;
}

/**
 * Copies an image out of the module's memory, so that it can be transferred.
 * @param {import('./types.js').GreyImage} image
 */
export const copyOf = ({ width, height, pixels }) => ({ width, height, pixels: pixels.slice() });
