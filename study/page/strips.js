// SPDX-License-Identifier: GPL-3.0-or-later
// Strip plots: one row a method, a dot a model, a bar at their median.
import { kColours } from './figure.js';
import { isOurs } from './methods.js';

/**
 * @param {import('./table.js').Row[]} rows  one a model and method
 * @param {import('./figure.js').Look} look
 * @param {{ measure: string, title: string, log?: boolean }[]} panels  each a plot of its own, side by side if they fit
 * @returns {import('./figure.js').Spec}
 */
export function methodStrips(rows, look, panels) {
  const marked = rows.map((row) => ({ ...row, isOurs: isOurs(row.method) }));
  const { rows: values, order } = look.named(marked, { model: 'model', method: 'method' });
  const across = look.narrow ? 1 : panels.length;
  /** @type {any} */
  const color = {
    field: 'isOurs',
    type: 'nominal',
    scale: { domain: [false, true], range: [kColours.blue, kColours.green] },
    legend: null,
  };
  return /** @type {import('./figure.js').Spec} */ ({
    data: { values },
    columns: across,
    spacing: 18,
    concat: panels.map(({ measure, title, log }, at) => ({
      width: look.plotWidth(across),
      height: { step: 26 },
      encoding: {
        y: {
          field: 'method',
          type: 'nominal',
          sort: order('method'),
          title: null,
          axis: { grid: true, labels: across === 1 || at === 0 },
        },
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
