// SPDX-License-Identifier: GPL-3.0-or-later
// Error of each method's own estimate of the light against path tracing.
import { distinct } from '../page/compare.js';
import { kDefaultMethod } from '../page/methods.js';
import { name, said } from '../page/say.js';
import { methodStrips } from '../page/strips.js';
import { typical } from './method_depths.js';

/** @typedef {import('../page/table.js').Row} Row */

/** @param {Row[]} rows */
const compared = (rows) => rows.filter((row) => row.light_error_size !== null);

/**
 * Sorts the methods by the size of their error, the smallest first; medians over the models.
 * @param {Row[]} rows
 * @returns {{ method: string, size: number, mean: number }[]}
 */
export const byError = (rows) =>
  distinct(compared(rows), 'method')
    .map((method) => ({
      method,
      size: typical(rows, method, 'light_error_size'),
      mean: typical(rows, method, 'light_error'),
    }))
    .sort((a, b) => a.size - b.size);

/** @type {import('../page/figure.js').Figure} */
export const lightErrors = {
  name: 'lightErrors',
  table: 'method_comparison',
  measures: ['light_error', 'light_error_size'],
  draw: (rows, look) =>
    methodStrips(compared(rows), look, [
      { measure: 'light_error_size', title: look.word('axisErrorSize') },
      { measure: 'light_error', title: look.word('axisError') },
    ]),
  find: (rows) => {
    const errors = byError(rows);
    const [least, most] = [errors[0], errors[errors.length - 1]];
    const ours = errors.find(({ method }) => method === kDefaultMethod);
    const fraction = (/** @type {number} */ number) => ({ number, digits: 3 });
    return [
      said('errorsRange', {
        least: name('method', least.method),
        leastError: fraction(least.size),
        most: name('method', most.method),
        mostError: fraction(most.size),
      }),
      ...(ours
        ? [
            said(ours.mean < 0 ? 'errorsOursDark' : 'errorsOursBright', {
              size: fraction(ours.size),
              mean: fraction(Math.abs(ours.mean)),
            }),
          ]
        : []),
      said('errorsWhy'),
    ];
  },
};
