// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of blur, distance and tilt, by pattern [Papp 2022, section 8].
import { groupBy, median, tally } from '../page/compare.js';
import { inOrder, seriesOfModels } from '../page/figure.js';
import { kLiteral, kPublished } from '../page/methods.js';
import { mm, name, said } from '../page/say.js';

/** @typedef {import('../page/table.js').Row} Row */

const kPanels = /** @type {const} */ ([
  ['blur_modules', 'axisBlur'],
  ['pixels_per_module', 'axisPixels'],
  ['tilt_deg', 'axisTilt'],
]);

/** Carved submodules of 25 in each pattern, in the paper's order of robustness. */
const kCarved = ['thin-plus', 'square', 'diamond', 'thick-plus', 'none'];

/** The patterns of the paper's test; its other pattern did not read at 1.2 mm. */
const kTestedByPaper = ['square', 'diamond', 'thick-plus'];

/**
 * Returns the median of a measure by module pattern.
 * @param {Row[]} rows
 * @param {string} measure
 * @param {string} [search]  a reading of the paper's search
 * @returns {Record<string, number>}
 */
export function byPattern(rows, measure, search = kPublished) {
  const groups = groupBy(
    rows.filter((row) => row.search === search && row[measure] !== null),
    'modules',
  );
  return Object.fromEntries(
    [...groups].map(([modules, ofPattern]) => [modules, median(ofPattern.map((row) => row[measure]))]),
  );
}

/**
 * Counts the pairs of patterns in which the pattern with fewer submodules has no more of the measure.
 * @param {Record<string, number>} values  by pattern
 */
export function moreCarvedSurvivesMore(values) {
  const known = kCarved.filter((pattern) => values[pattern] !== undefined);
  const pairs = known.flatMap((less, at) => known.slice(at + 1).map((more) => [less, more]));
  return tally(pairs, ([less, more]) => values[less] <= values[more]);
}

/** @type {import('../page/figure.js').Figure} */
export const robustness = {
  name: 'robustness',
  table: 'robustness',
  measures: ['blur_modules'],
  draw: (all, look) => {
    const rows = all.filter(({ search }) => search !== kLiteral);
    const carving = (/** @type {Row} */ row) =>
      row.search === 'ours'
        ? look.word('carvingOurs')
        : look.word('carvingPattern', { modules: name('pattern', row.modules), finders: name('finder', row.finders) });
    const byRank = inOrder(rows, 'search', 'search').flatMap((search) =>
      inOrder(rows, 'modules', 'pattern').flatMap((modules) =>
        rows.filter((row) => row.search === search && row.modules === modules),
      ),
    );
    const carvings = [...new Set(byRank.map(carving))];
    const { rows: values, order } = look.named(
      rows.map((row) => ({ ...row, carving: carving(row) })),
      { model: 'model' },
    );
    const across = look.narrow ? 1 : 3;
    return /** @type {any} */ ({
      data: { values },
      columns: across,
      spacing: 16,
      concat: kPanels.map(([measure, title], at) => ({
        width: look.plotWidth(across),
        height: { step: 22 },
        mark: { type: 'point', size: 44, strokeWidth: 1.7 },
        encoding: {
          y: {
            field: 'carving',
            type: 'nominal',
            sort: carvings,
            title: null,
            axis: { grid: true, labels: look.narrow || at === 0 },
          },
          x: { field: measure, type: 'quantitative', title: look.word(title) },
          ...seriesOfModels(order('model')),
        },
      })),
    });
  },
  find: (all) => {
    const rows = all.filter(({ search }) => search !== kLiteral);
    const blur = byPattern(rows, 'blur_modules');
    const patterns = kCarved.filter((pattern) => blur[pattern] !== undefined);
    const pairs = moreCarvedSurvivesMore(blur);
    const ofPaper = moreCarvedSurvivesMore(
      Object.fromEntries(kTestedByPaper.map((pattern) => [pattern, blur[pattern]])),
    );
    const unread = rows.filter((row) => row.blur_modules === null).length;
    const ours = rows.filter((row) => row.search === 'ours' && row.blur_modules !== null);
    return [
      said('robustPairs', { holds: pairs.holds, of: pairs.of, paperHolds: ofPaper.holds, paperOf: ofPaper.of }),
      said('robustBlur', {
        list: patterns.map((pattern) =>
          said('robustOf', { pattern: name('pattern', pattern), blur: mm(blur[pattern]) }),
        ),
      }),
      said('robustOurs', {
        blur: mm(median(ours.map((row) => row.blur_modules))),
        tilt: Math.round(median(ours.map((row) => row.tilt_deg ?? 0))),
      }),
      ...(unread > 0 ? [said('robustUnread', { count: unread, of: rows.length })] : []),
      said('robustPaper'),
    ];
  },
};
