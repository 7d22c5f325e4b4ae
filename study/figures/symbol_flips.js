// SPDX-License-Identifier: GPL-3.0-or-later
// Dark areas broken up within the error correction: what it saves and what it costs.
import { median, valuesBy } from '../page/compare.js';
import { kColours, series } from '../page/figure.js';
import { said } from '../page/say.js';

/** @typedef {import('../page/table.js').Row} Row */

/** How much shallower flips make codes, as a fraction; median over the models. @param {Row[]} rows @param {string} search @param {string} flips */
export function savedByFlips(rows, search, flips) {
  const saved = [...new Set(rows.map(({ model }) => model))].flatMap((model) => {
    const depths = valuesBy(rows.filter((row) => row.model === model && row.search === search), 'flips', 'depth_mm');
    const [before, after] = [depths.none, depths[flips]];
    return before === undefined || after === undefined ? [] : [1 - after / before];
  });
  return median(saved);
}

/** Tries that flips lose or win as printed; median over the models. @param {Row[]} rows @param {string} search @param {string} flips */
export function triesByFlips(rows, search, flips) {
  return median([...new Set(rows.map(({ model }) => model))].flatMap((model) => {
    const reads = valuesBy(rows.filter((row) => row.model === model && row.search === search), 'flips', 'printed');
    const [before, after] = [reads.none, reads[flips]];
    return before === undefined || after === undefined ? [] : [after - before];
  }));
}

/** @type {import('../page/figure.js').Figure} */
export const symbolFlips = {
  name: 'symbolFlips', table: 'symbol_flips', measures: ['depth_mm', 'printed'],
  draw: (rows, look) => {
    const { rows: values, order } = look.named(rows, { model: 'model', search: 'search', flips: 'flips' });
    const columns = look.narrow ? 1 : 2;
    return {
      data: { values }, columns,
      facet: { field: 'search', type: 'nominal', sort: order('search') },
      spec: {
        width: look.plotWidth(columns), height: { step: 30 },
        mark: { type: 'point', size: 52, strokeWidth: 1.8 },
        encoding: {
          y: { field: 'flips', type: 'nominal', sort: order('flips'), title: null, axis: { grid: true } },
          x: { field: 'depth_mm', type: 'quantitative', title: look.word('axisDepth') },
          ...series('model', order('model'), [kColours.grey, kColours.blue, kColours.orange], ['circle', 'square', 'triangle-up']),
        },
      },
    };
  },
  find: (rows) => {
    const flipped = (/** @type {string} */ flips) => Math.round(median(rows.filter((row) => row.flips === flips).map((row) => row.flipped_modules)));
    const percent = (/** @type {string} */ search, /** @type {string} */ flips) => Math.round(100 * savedByFlips(rows, search, flips));
    const tries = ['self-shadow-2019', 'ours'].flatMap((search) => ['peng-2019', 'ours'].map((flips) => Math.abs(triesByFlips(rows, search, flips))));
    return [
      said('flipsCount', { peng: flipped('peng-2019'), ours: flipped('ours') }),
      said('flipsSaved', { peng2019: percent('self-shadow-2019', 'peng-2019'), ours2019: percent('self-shadow-2019', 'ours'), peng: percent('ours', 'peng-2019'), ours: percent('ours', 'ours') }),
      said('flipsReads', { tries: Math.round(Math.max(...tries)) }),
    ];
  },
};
