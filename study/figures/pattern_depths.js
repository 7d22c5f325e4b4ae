// SPDX-License-Identifier: GPL-3.0-or-later
// Depth by module pattern and finder pattern [Papp 2022, figures 15 and 16].
import { groupBy, median, onModels, tally, valuesBy } from '../page/compare.js';
import { ofSearch } from '../page/methods.js';
import { patternPlots } from '../page/plots.js';
import { cases, mm, models, said } from '../page/say.js';
import { kNeeded, kTries } from '../page/tries.js';

/** @typedef {import('../page/table.js').Row} Row */

/** Returns depths by module pattern. @param {Row[]} ofModel @param {string} finders  pattern of the finder patterns */
const depthsOf = (ofModel, finders) => {
  const depths = valuesBy(
    ofModel.filter((row) => row.finders === finders),
    'modules',
    'depth_mm',
  );
  return ['none', 'square', 'thin-plus', 'diamond', 'thick-plus'].every((pattern) => depths[pattern] !== undefined)
    ? /** @type {Record<string, number>} */ (depths)
    : undefined;
};

/** True if the two patterns that do not connect are the shallowest. @param {Row[]} ofModel @param {string} [finders] */
export function looseAreShallowest(ofModel, finders = 'as-modules') {
  const depths = depthsOf(ofModel, finders);
  return (
    depths && Math.max(depths.square, depths['thin-plus']) < Math.min(depths.none, depths.diamond, depths['thick-plus'])
  );
}

/** @param {Row[]} ofModel */
export function thinPlusIsShallowest(ofModel) {
  const depths = depthsOf(ofModel, 'as-modules');
  return depths && Object.values(depths).every((depth) => depth >= depths['thin-plus']);
}

/** True if thick plus is the deepest pattern; whole modules are no pattern. @param {Row[]} ofModel */
export function thickPlusIsDeepest(ofModel) {
  const depths = depthsOf(ofModel, 'as-modules');
  return depths && ['square', 'thin-plus', 'diamond'].every((pattern) => depths[pattern] <= depths['thick-plus']);
}

/** True if every pattern is shallower than whole modules. @param {Row[]} ofModel */
export function patternsAreShallower(ofModel) {
  const depths = depthsOf(ofModel, 'as-modules');
  return depths && Object.entries(depths).every(([pattern, depth]) => pattern === 'none' || depth < depths.none);
}

/** Returns how far apart the depths of square and diamond are, mm. @param {Row[]} ofModel */
export function squareFromDiamond(ofModel) {
  const depths = depthsOf(ofModel, 'as-modules');
  return depths && Math.abs(depths.square - depths.diamond);
}

/** Counts the cases in which patterned finder patterns are shallower than whole ones. @param {Row[]} rows */
export function findersLowerDepth(rows) {
  const whole = new Map(
    rows.filter(({ finders }) => finders === 'none').map((row) => [`${row.model} ${row.modules}`, row.depth_mm]),
  );
  return tally(
    rows.filter(({ finders }) => ['diamond', 'thick-plus'].includes(finders)),
    (row) => {
      const depth = whole.get(`${row.model} ${row.modules}`);
      return depth === undefined ? undefined : row.depth_mm < depth;
    },
  );
}

/**
 * Returns the largest difference between the paper's two finder patterns, in mm.
 * @param {Row[]} rows
 * @returns {number}
 */
export function findersApart(rows) {
  const groups = groupBy(
    rows.map((row) => ({ ...row, others: `${row.model} ${row.modules}` })),
    'others',
  );
  return Math.max(
    ...[...groups.values()].map((group) => {
      const { diamond, 'thick-plus': thickPlus } = valuesBy(group, 'finders', 'depth_mm');
      return diamond === undefined || thickPlus === undefined ? 0 : Math.abs(diamond - thickPlus);
    }),
  );
}

/** @type {import('../page/figure.js').Figure} */
export const patternDepths = {
  name: 'patternDepths',
  table: 'pattern_depths',
  measures: ['depth_mm', 'designed', 'printed'],
  draw: (rows, look) => {
    const { rows: values, order } = look.named(ofSearch(rows), { model: 'model' });
    return patternPlots(values, look, {
      plots: { field: 'model', names: order('model') },
      columns: look.narrow ? 2 : 4,
      x: { field: 'depth_mm', title: look.word('axisDepth') },
    });
  },
  find: (all) => {
    const rows = ofSearch(all);
    const finders = findersLowerDepth(rows);
    const reads = (/** @type {string} */ pattern) =>
      Math.round(median(rows.filter(({ modules }) => modules === pattern).map(({ printed }) => printed)));
    const readsWith = (/** @type {Row[]} */ some) => ({
      cases: cases(tally(some, ({ designed }) => designed >= kNeeded)),
      printed: cases(tally(some, ({ printed }) => printed >= kNeeded)),
    });
    const withFinders = (/** @type {string} */ pattern) => rows.filter((row) => row.finders === pattern);
    const [diamond, thick] = [withFinders('diamond'), readsWith(withFinders('thick-plus'))];
    const tries = diamond.map(({ designed }) => designed);
    const loose = (/** @type {string} */ finderPattern) =>
      models(onModels(rows, (ofModel) => looseAreShallowest(ofModel, finderPattern)));
    const alike = rows.filter((row) => row.finders === 'as-modules' && row.modules !== 'none');
    return [
      said('patternsLoose', {
        cases: loose('as-modules'),
        diamond: loose('diamond'),
        whole: loose('none'),
        thick: loose('thick-plus'),
      }),
      said('patternsBest', {
        best: models(onModels(rows, thinPlusIsShallowest)),
        last: models(onModels(rows, thickPlusIsDeepest)),
      }),
      said('patternsFinders', { cases: cases(finders), apart: mm(findersApart(rows)) }),
      said('patternsWhole', readsWith(alike)),
      said('patternsDiamond', {
        ...readsWith(diamond),
        thick: thick.cases,
        thickPrinted: thick.printed,
        least: Math.min(...tries),
        most: Math.max(...tries),
        needed: kNeeded,
        tries: kTries,
      }),
      said('patternsReads', {
        thin: reads('thin-plus'),
        square: reads('square'),
        diamond: reads('diamond'),
        thick: reads('thick-plus'),
        whole: reads('none'),
      }),
    ];
  },
};
