// SPDX-License-Identifier: GPL-3.0-or-later
// What the module answers, as values of the page's own.
import { EngineFailure } from './engine_error.js';

/**
 * The module's answer as a value; a failure is thrown.
 * @param {string} json
 * @returns {any}
 */
export function parseAnswer(json) {
  const answer = JSON.parse(json);
  if (answer.ok === false || answer.error) throw new EngineFailure(answer.error);
  return answer;
}

/** One that can be handed over. @param {import('./types.js').GreyImage} image */
export const copyOf = ({ width, height, pixels }) => ({ width, height, pixels: pixels.slice() });
