// SPDX-License-Identifier: GPL-3.0-or-later
// How large a code each way to find the direction allows [Papp 2022, figures 13 and 14].
import { median, onModels, valuesBy } from '../page/compare.js';
import { kColours, series } from '../page/figure.js';
import { mm, models, name, said } from '../page/say.js';

/** @typedef {import('../page/table.js').Row} Row */

const kMeasures = ['guaranteed_mm', 'upright_mm', 'turned_45_mm'];
const kSameFraction = 0.02;  // differences below it nobody sees on a model

/** What depth adds to the guaranteed size, as a fraction of that by normals alone. @param {Row[]} ofModel @returns {number | undefined} */
export function gainByDepth(ofModel) {
  const { 'depth-balanced': balanced, 'mean-normal': normals } = valuesBy(ofModel, 'direction', 'guaranteed_mm');
  return balanced === undefined || normals === undefined ? undefined : balanced / normals - 1;
}

/** Whether the direction `optimal` allows the largest guaranteed size. @param {Row[]} ofModel */
export function optimalIsLargest(ofModel) {
  const sizes = valuesBy(ofModel, 'direction', 'guaranteed_mm');
  return sizes.optimal === undefined ? undefined : sizes.optimal >= Math.max(...Object.values(sizes).map(Number));
}

/** @type {import('../page/figure.js').Figure} */
export const guaranteedSize = {
  name: 'guaranteedSize', table: 'guaranteed_size', measures: kMeasures,
  draw: (rows, look) => {
    const long = rows.flatMap((row) => kMeasures.map((how) => ({ ...row, how, mm: row[how] })));
    const { rows: values, order } = look.named(long, { model: 'model', direction: 'direction', how: 'size' });
    const columns = look.narrow ? 1 : 3;
    return {
      data: { values }, columns,
      facet: { field: 'how', type: 'nominal', sort: order('how') },
      spec: {
        width: look.plotWidth(columns), height: { step: 34, for: 'position' },
        mark: { type: 'point', size: 30, strokeWidth: 1.6 },
        encoding: {
          y: { field: 'model', type: 'nominal', sort: order('model'), title: null, axis: { grid: true } },
          x: { field: 'mm', type: 'quantitative', title: look.word('axisEdge'), scale: { zero: false } },
          yOffset: { field: 'direction', type: 'nominal', sort: order('direction') },
          ...series('direction', order('direction'), [kColours.grey, kColours.blue, kColours.purple, kColours.green],
            ['circle', 'square', 'triangle-up', 'cross']),
        },
      },
    };
  },
  find: (rows) => {
    const gains = [...new Set(rows.map(({ model }) => model))].map((model) => ({ model, gain: gainByDepth(rows.filter((row) => row.model === model)) }))
      .flatMap(({ model, gain }) => (gain === undefined ? [] : [{ model, gain }])).sort((a, b) => b.gain - a.gain);
    if (gains.length === 0) return [];
    const [most, least] = [gains[0], gains[gains.length - 1]];
    const turned = median(rows.filter(({ direction }) => direction === 'depth-balanced').map((row) => row.upright_mm / row.guaranteed_mm));
    return [
      said('sizesSame', { cases: models({ holds: gains.filter(({ gain }) => Math.abs(gain) < kSameFraction).length, of: gains.length }), percent: 100 * kSameFraction }),
      said('sizesMost', { model: name('model', most.model), percent: { number: 100 * most.gain, digits: 1 } }),
      ...(least.gain < -0.001 ? [said('sizesLeast', { model: name('model', least.model), percent: { number: 100 * -least.gain, digits: 1 } })] : []),
      said('sizesOptimal', { cases: models(onModels(rows, optimalIsLargest)) }),
      said('sizesTurned', { times: mm(turned) }),
      said('sizesPaper'),
    ];
  },
};
