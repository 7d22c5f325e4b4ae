// SPDX-License-Identifier: GPL-3.0-or-later
// Plots with a row for each method, a dot for each model, and a bar at the median.
import { kColours } from './figure.js';
import { isOurs } from './methods.js';

/**
 * @param {import('./table.js').Row[]} rows  one for each model and method
 * @param {import('./figure.js').Look} look
 * @param {{ measure: string, title: string, log?: boolean }[]} panels  one plot each, side by side if there is room
 * @returns {import('./figure.js').Spec}
 */
export function methodStrips(rows, look, panels) {
  const marked = rows.map((row) => ({ ...row, isOurs: isOurs(row.method) }));
  const { rows: values, order } = look.named(marked, { model: 'model', method: 'method' });
  const across = look.narrow ? 1 : panels.length;
  /** @type {any} */
  const color = {
    field: 'isOurs', type: 'nominal', scale: { domain: [false, true], range: [kColours.blue, kColours.green] }, legend: null,
  };
  return /** @type {import('./figure.js').Spec} */ ({
    data: { values }, columns: across, spacing: 18,
    concat: panels.map(({ measure, title, log }, at) => ({
      width: look.plotWidth(across), height: { step: 26 },
      encoding: {
        y: { field: 'method', type: 'nominal', sort: order('method'), title: null, axis: { grid: true, labels: across === 1 || at === 0 } },
      },
      layer: [
        {
          mark: { type: 'point', filled: true, opacity: 0.5, size: 40 },
          encoding: { x: { field: measure, type: 'quantitative', title, scale: log ? { type: 'log' } : {} }, color },
        },
        {
          mark: { type: 'tick', thickness: 3, size: 18, opacity: 1 },
          encoding: { x: { field: measure, type: 'quantitative', aggregate: 'median' }, color },
        },
      ],
    })),
  });
}
