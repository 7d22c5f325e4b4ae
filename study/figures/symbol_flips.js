// SPDX-License-Identifier: GPL-3.0-or-later
// Dark areas broken up within the error correction: saved depth and lost tries.
import { groupBy, median, valuesBy } from '../page/compare.js';
import { seriesOfModels } from '../page/figure.js';
import { said } from '../page/say.js';

/** @typedef {import('../page/table.js').Row} Row */

/**
 * Returns the change by flips, median over the models that have both.
 * @param {Row[]} rows
 * @param {string} search
 * @param {string} flips
 * @param {string} measure
 * @param {(before: number, after: number) => number} change
 */
const changeBy = (rows, search, flips, measure, change) =>
  median(
    [...groupBy(rows, 'model').values()].flatMap((ofModel) => {
      const values = valuesBy(
        ofModel.filter((row) => row.search === search),
        'flips',
        measure,
      );
      const [before, after] = [values.none, values[flips]];
      return before === undefined || after === undefined ? [] : [change(before, after)];
    }),
  );

/**
 * Returns how much shallower flips make codes, as a fraction.
 * @param {Row[]} rows
 * @param {string} search
 * @param {string} flips
 */
export const savedByFlips = (rows, search, flips) =>
  changeBy(rows, search, flips, 'depth_mm', (before, after) => 1 - after / before);

/**
 * Returns the decoded tries as printed that flips gain.
 * @param {Row[]} rows
 * @param {string} search
 * @param {string} flips
 */
export const triesByFlips = (rows, search, flips) =>
  changeBy(rows, search, flips, 'printed', (before, after) => after - before);

/** @type {import('../page/figure.js').Figure} */
export const symbolFlips = {
  name: 'symbolFlips',
  table: 'symbol_flips',
  measures: ['depth_mm', 'printed'],
  draw: (rows, look) => {
    const { rows: values, order } = look.named(rows, { model: 'model', search: 'search', flips: 'flips' });
    const columns = look.narrow ? 1 : 2;
    return {
      data: { values },
      columns,
      facet: { field: 'search', type: 'nominal', sort: order('search') },
      spec: {
        width: look.plotWidth(columns),
        height: { step: 30 },
        mark: { type: 'point', size: 52, strokeWidth: 1.8 },
        encoding: {
          y: { field: 'flips', type: 'nominal', sort: order('flips'), title: null, axis: { grid: true } },
          x: { field: 'depth_mm', type: 'quantitative', title: look.word('axisDepth') },
          ...seriesOfModels(order('model')),
        },
      },
    };
  },
  find: (rows) => {
    const flipped = (/** @type {string} */ flips) =>
      Math.round(median(rows.filter((row) => row.flips === flips).map((row) => row.flipped_modules)));
    const percent = (/** @type {string} */ search, /** @type {string} */ flips) =>
      Math.round(100 * savedByFlips(rows, search, flips));
    const tries = ['self-shadow-2019', 'ours'].flatMap((search) =>
      ['peng-2019', 'ours'].map((flips) => Math.abs(triesByFlips(rows, search, flips))),
    );
    return [
      said('flipsCount', { peng: flipped('peng-2019'), ours: flipped('ours') }),
      said('flipsSaved', {
        peng2019: percent('self-shadow-2019', 'peng-2019'),
        ours2019: percent('self-shadow-2019', 'ours'),
        peng: percent('ours', 'peng-2019'),
        ours: percent('ours', 'ours'),
      }),
      said('flipsReads', { tries: Math.round(Math.max(...tries)) }),
    ];
  },
};
