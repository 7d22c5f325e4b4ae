// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts that several figures share: a plot for each value of a column, with marks or lines of a series.
import { kColours, series } from './figure.js';

/** @typedef {import('./table.js').Row} Row */
/** @typedef {import('./figure.js').Look} Look */
/** @typedef {import('./figure.js').Spec} Spec */
/**
 * The column that splits the plots, with names as values, and these names in order.
 * @typedef {{ field: string, names: string[] }} Plots
 */
/** @typedef {{ field: string, title: string }} Axis */

/** @param {Row[]} values @param {Look} look @param {Plots} plots @param {number} columns @param {object} plot @returns {any} */
const plotsOf = (values, look, { field, names }, columns, plot) => ({
  data: { values },
  columns,
  facet: { field, type: 'nominal', sort: names },
  spec: { width: look.plotWidth(columns), ...plot },
});

/**
 * Plots a row for each module pattern, a mark for each finder pattern.
 * @param {Row[]} rows
 * @param {Look} look
 * @param {{ plots: Plots, columns: number, x: Axis }} shape
 * @returns {Spec}
 */
export function patternPlots(rows, look, { plots, columns, x }) {
  const { rows: values, order } = look.named(rows, { modules: 'pattern', finders: 'finder' });
  return plotsOf(values, look, plots, columns, {
    height: { step: 21 },
    mark: { type: 'point', size: 36, strokeWidth: 1.6 },
    encoding: {
      y: { field: 'modules', type: 'nominal', sort: order('modules'), title: null, axis: { grid: true } },
      x: { ...x, type: 'quantitative' },
      ...series(
        'finders',
        order('finders'),
        [kColours.grey, kColours.ink, kColours.orange, kColours.blue, kColours.green],
        ['circle', 'square', 'diamond', 'cross', 'triangle-up'],
        look.word('legendFinders'),
      ),
    },
  });
}

/**
 * Plots lines over steps that need not be even.
 * @param {Row[]} values
 * @param {Look} look
 * @param {{ plots: Plots, columns: number, height: number, x: Axis, y: Axis, lines: ReturnType<typeof series> }} shape
 * @returns {Spec}
 */
export const linePlots = (values, look, { plots, columns, height, x, y, lines }) =>
  plotsOf(values, look, plots, columns, {
    height,
    mark: { type: 'line', point: { size: 44 }, strokeWidth: 2 },
    encoding: {
      x: { ...x, type: 'ordinal', axis: { labelAngle: 0 } },
      y: { ...y, type: 'quantitative', scale: { nice: 4 } },
      ...lines,
    },
  });
