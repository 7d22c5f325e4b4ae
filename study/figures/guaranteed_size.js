// SPDX-License-Identifier: GPL-3.0-or-later
// Largest code for each way to find the direction [Papp 2022, figures 13 and 14].
import { groupBy, median, onModels, tally, valuesBy } from '../page/compare.js';
import { kColours, series } from '../page/figure.js';
import { mm, models, name, said } from '../page/say.js';

/** @typedef {import('../page/table.js').Row} Row */

const kMeasures = ['guaranteed_mm', 'upright_mm', 'turned_45_mm'];
const kSameFraction = 0.02; // smaller differences are invisible on a model
const kShownFraction = 0.001; // a smaller loss would show as 0.0 %

/**
 * Returns the gain of guaranteed size by depth, as a fraction of the size by normals alone.
 * @param {Row[]} ofPlace
 * @returns {number | undefined}
 */
export function gainByDepth(ofPlace) {
  const { 'depth-balanced': balanced, 'mean-normal': normals } = valuesBy(ofPlace, 'direction', 'guaranteed_mm');
  return balanced === undefined || normals === undefined ? undefined : balanced / normals - 1;
}

/**
 * Returns what depth adds to the guaranteed size at each place, as a fraction.
 * @param {Row[]} rows  of random_sizes
 */
export const gainsAtPlaces = (rows) =>
  [...groupBy(rows, 'model').values()]
    .flatMap((ofModel) => [...groupBy(ofModel, 'place').values()])
    .map(gainByDepth)
    .filter((gain) => gain !== undefined);

/** True if the direction `optimal` allows the largest guaranteed size. @param {Row[]} ofModel */
export function optimalIsLargest(ofModel) {
  const sizes = valuesBy(ofModel, 'direction', 'guaranteed_mm');
  return sizes.optimal === undefined ? undefined : sizes.optimal >= Math.max(...Object.values(sizes).map(Number));
}

/** @type {import('../page/figure.js').Figure} */
export const guaranteedSize = {
  name: 'guaranteedSize',
  table: 'guaranteed_size',
  measures: kMeasures,
  draw: (rows, look) => {
    const long = rows.flatMap((row) => kMeasures.map((how) => ({ ...row, how, mm: row[how] })));
    const { rows: values, order } = look.named(long, { model: 'model', direction: 'direction', how: 'size' });
    const columns = look.narrow ? 1 : 3;
    return {
      data: { values },
      columns,
      facet: { field: 'how', type: 'nominal', sort: order('how') },
      spec: {
        width: look.plotWidth(columns),
        height: { step: 34, for: 'position' },
        mark: { type: 'point', size: 30, strokeWidth: 1.6 },
        encoding: {
          y: { field: 'model', type: 'nominal', sort: order('model'), title: null, axis: { grid: true } },
          x: { field: 'mm', type: 'quantitative', title: look.word('axisEdge'), scale: { zero: false } },
          yOffset: { field: 'direction', type: 'nominal', sort: order('direction') },
          ...series(
            'direction',
            order('direction'),
            [kColours.grey, kColours.blue, kColours.purple, kColours.green],
            ['circle', 'square', 'triangle-up', 'cross'],
          ),
        },
      },
    };
  },
  find: (rows) => {
    const gains = [...groupBy(rows, 'model')]
      .map(([model, ofModel]) => ({ model, gain: gainByDepth(ofModel) ?? NaN }))
      .filter(({ gain }) => Number.isFinite(gain))
      .sort((a, b) => b.gain - a.gain);
    if (gains.length === 0) return [];
    const same = tally(gains, ({ gain }) => Math.abs(gain) < kSameFraction);
    const percent = (/** @type {number} */ fraction) => ({ number: 100 * fraction, digits: 1 });
    const [most, least] = [gains[0], gains[gains.length - 1]];
    const turned = median(
      rows.filter(({ direction }) => direction === 'depth-balanced').map((row) => row.upright_mm / row.guaranteed_mm),
    );
    return [
      said('sizesSame', { cases: models(same), percent: 100 * kSameFraction }),
      said('sizesMost', { model: name('model', most.model), percent: percent(most.gain) }),
      ...(least.gain < -kShownFraction
        ? [said('sizesLeast', { model: name('model', least.model), percent: percent(-least.gain) })]
        : []),
      said('sizesOptimal', { cases: models(onModels(rows, optimalIsLargest)) }),
      said('sizesTurned', { times: mm(turned) }),
      said('sizesPaper'),
    ];
  },
};
