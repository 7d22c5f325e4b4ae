// SPDX-License-Identifier: GPL-3.0-or-later
// The state of each step: one line next to its heading, and the mark before it.
import { write } from '../i18n/live.js';
import { byId } from '../dom/dom.js';

/** @typedef {import('../i18n/live.js').Words} Words */
/** @typedef {'model' | 'code' | 'place' | 'carve' | 'check' | 'parts'} Step */
/** @typedef {'open' | 'done' | 'warn' | 'bad'} State */

/** @type {Record<Step, string>} */
const kLines = {
  model: 'model-state',
  code: 'code-state',
  place: 'placement-facts',
  carve: 'carve-state',
  check: 'check-state',
  parts: 'parts-state',
};

/** @param {Step} step @param {State} state */
export function markStep(step, state) {
  byId(`step-${step}`, HTMLElement).dataset.state = state;
}

/** @param {Step} step @param {Words} words */
export function describeStep(step, words) {
  write(byId(kLines[step], HTMLElement), words);
}

/** @param {Step} step @param {State} state @param {Words} words */
export function showStep(step, state, words) {
  markStep(step, state);
  describeStep(step, words);
}
