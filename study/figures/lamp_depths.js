// SPDX-License-Identifier: GPL-3.0-or-later
// Depth by the number of lamps [Papp 2022, figure 21].
import { median, onModels, rises, valuesBy } from '../page/compare.js';
import { kColours, series } from '../page/figure.js';
import { ofSearch } from '../page/methods.js';
import { linePlots } from '../page/plots.js';
import { mm, models, said } from '../page/say.js';

/** @typedef {import('../page/table.js').Row} Row */

/** Returns depths by number of lamps: none, one, two. @param {Row[]} ofModel @param {string} pattern */
const depthsOf = (ofModel, pattern) => {
  const depths = valuesBy(
    ofModel.filter(({ modules }) => modules === pattern),
    'lamps',
    'depth_mm',
  );
  return [0, 1, 2].map((lamps) => depths[lamps]);
};

/** True if each further lamp makes codes deeper. @param {Row[]} ofModel @param {string} pattern */
export const lampsDeepen = (ofModel, pattern) => rises(depthsOf(ofModel, pattern));

/** True if each further lamp makes codes shallower. @param {Row[]} ofModel @param {string} pattern */
export const lampsMakeShallower = (ofModel, pattern) => rises(depthsOf(ofModel, pattern).reverse());

/** @type {import('../page/figure.js').Figure} */
export const lampDepths = {
  name: 'lampDepths',
  table: 'lamp_depths',
  measures: ['depth_mm'],
  draw: (rows, look) => {
    const { rows: values, order } = look.named(ofSearch(rows), { model: 'model', modules: 'pattern' });
    return linePlots(values, look, {
      plots: { field: 'model', names: order('model') },
      columns: look.narrow ? 2 : 4,
      height: 110,
      x: { field: 'lamps', title: look.word('axisLamps') },
      y: { field: 'depth_mm', title: look.word('axisDepth') },
      lines: series('modules', order('modules'), [kColours.orange, kColours.blue], ['circle', 'square']),
    });
  },
  find: (all) => {
    const rows = ofSearch(all);
    const typical = (/** @type {string} */ pattern, /** @type {number} */ lamps) =>
      mm(
        median(
          rows.filter((row) => row.modules === pattern && row.lamps === lamps).map(({ depth_mm: depth }) => depth),
        ),
      );
    const deeper = onModels(rows, (ofModel) => lampsDeepen(ofModel, 'square'));
    const shallower = onModels(rows, (ofModel) => lampsMakeShallower(ofModel, 'none'));
    const fails = deeper.holds < deeper.of || shallower.holds < shallower.of;
    return [
      said('lampsPattern', {
        cases: models(deeper),
        none: typical('square', 0),
        one: typical('square', 1),
        two: typical('square', 2),
      }),
      said('lampsWhole', {
        cases: models(shallower),
        none: typical('none', 0),
        one: typical('none', 1),
        two: typical('none', 2),
      }),
      ...(fails ? [said('lampsWhy')] : []),
    ];
  },
};
