// SPDX-License-Identifier: GPL-3.0-or-later
// Choice of the default: decoded tries as printed against depth, for the settings that a search left, on models that
// the choice did not use.
import { groupBy, tally } from '../page/compare.js';
import { kColours, series } from '../page/figure.js';
import { name, said } from '../page/say.js';
import { kNeeded, kTries } from '../page/tries.js';

/** @typedef {import('../page/table.js').Row} Row */
/**
 * Means over poses, and over models if several are given.
 * @typedef {{ modules: string, finders: string, contrast: number, isDefault: boolean, printed: number, depth_mm: number, depth_max_mm: number }} Choice
 */

/** The models that the default was chosen by (study/experiments/chosen_settings.h). */
export const kChosenBy = ['plate', 'saddle', 'star', 'bunny'];

const kMeasures = /** @type {const} */ (['printed', 'depth_mm', 'depth_max_mm']);
const kSettings = ['modules', 'finders', 'contrast', 'max_depth_modules', 'broken_up'];
const kMisleading = 'diamond'; // our decoder decodes these modules more often than other decoders do
const kDefaultDepthModules = 4; // pipeline/default_patterns.h

/**
 * Returns the results of each choice of settings with modules of one width.
 * @param {Row[]} rows  of that width
 * @param {Row | undefined} ours  the program's settings for that width, of the table default_settings
 * @returns {Choice[]}
 */
export function choicesOf(rows, ours) {
  const groups = groupBy(
    rows.map((row) => ({ ...row, choice: kSettings.map((column) => row[column]).join(' ') })),
    'choice',
  );
  return [...groups.values()].map((group) => {
    const [{ modules, finders, contrast, max_depth_modules: most, broken_up: brokenUp }] = group;
    const isDefault =
      modules === ours?.modules &&
      finders === ours?.finders &&
      contrast === ours?.contrast &&
      most === kDefaultDepthModules &&
      brokenUp === 'no';
    const means = Object.fromEntries(
      kMeasures.map((measure) => [measure, group.reduce((sum, row) => sum + row[measure], 0) / group.length]),
    );
    return /** @type {Choice} */ ({ modules, finders, contrast, isDefault, ...means });
  });
}

/**
 * Returns choices with more decoded tries than the default at no more depth; undefined if the default was not measured.
 * @param {Choice[]} choices
 */
export function betterThanDefault(choices) {
  const ours = choices.find(({ isDefault }) => isDefault);
  return ours && choices.filter(({ printed, depth_mm: depth }) => printed > ours.printed && depth <= ours.depth_mm);
}

/** Returns the rows of the models that the choice did not use. @param {Row[]} rows */
const tested = (rows) => rows.filter(({ model }) => !kChosenBy.includes(model));

/** Returns the program's settings by module width. @param {Record<string, Row[]>} tables */
const settingsBy = ({ default_settings: settings = [] }) => new Map(settings.map((row) => [row.module_mm, row]));

/** @param {number} width  of modules, mm @param {import('../page/compare.js').Tally} test */
const at = (width, { holds, of }) => said('choiceFrontierAt', { width: { number: width, digits: 1 }, holds, of });

/** @type {import('../page/figure.js').Figure} */
export const defaultChoice = {
  name: 'defaultChoice',
  table: 'default_choice',
  measures: ['depth_mm', 'printed', 'depth_max_mm'],
  draw: (rows, look, tables) => {
    const settings = settingsBy(tables);
    const kinds = new Map();
    const points = [...groupBy(tested(rows), 'module_mm')].flatMap(([width, ofWidth]) =>
      choicesOf(ofWidth, settings.get(width)).map((choice) => {
        const kind = look.word('carvingPattern', {
          modules: name('pattern', choice.modules),
          finders: name('finder', choice.finders),
        });
        kinds.set(kind, true);
        return { ...choice, kind, width: look.word('moduleOf', { width }) };
      }),
    );
    const widths = [...new Set(points.map(({ width }) => width))];
    const columns = look.narrow ? 2 : 4;
    const across = (/** @type {string} */ field, /** @type {string} */ title) => ({
      field,
      type: 'quantitative',
      title,
      scale: { zero: false, nice: true },
    });
    const y = {
      field: 'printed',
      type: 'quantitative',
      title: look.word('axisReads', { of: kTries }),
      scale: { domain: [20, kTries], zero: false },
      axis: { values: [20, 40, 60] },
    };
    const kind = series(
      'kind',
      [...kinds.keys()],
      [kColours.blue, kColours.teal, kColours.purple, kColours.green, kColours.orange, kColours.olive],
      ['square', 'diamond', 'triangle-down', 'cross', 'triangle-up', 'circle'],
    );
    for (const of of [kind.color, kind.shape]) Object.assign(of.legend, { columns: look.narrow ? 1 : 3 });
    const plots = (/** @type {string} */ field, /** @type {string} */ title) => ({
      columns,
      facet: { field: 'width', type: 'nominal', sort: widths },
      spec: {
        width: look.plotWidth(columns),
        height: 150,
        layer: [
          { mark: { type: 'rule', strokeDash: [5, 4], color: kColours.soft }, encoding: { y: { datum: kNeeded } } },
          { mark: { type: 'point', size: 34, strokeWidth: 1.6 }, encoding: { x: across(field, title), y, ...kind } },
          {
            transform: [{ filter: 'datum.isDefault' }],
            mark: { type: 'point', shape: 'circle', size: 190, strokeWidth: 1.6, color: kColours.ink },
            encoding: { x: across(field, title), y },
          },
        ],
      },
    });
    return /** @type {any} */ ({
      data: { values: points },
      spacing: 22,
      vconcat: [plots('depth_mm', look.word('axisDepth')), plots('depth_max_mm', look.word('axisGreatestDepth'))],
    });
  },
  find: (rows, tables) => {
    const settings = settingsBy(tables);
    const byWidth = [...groupBy(rows, 'module_mm')].map(([width, ofWidth]) => {
      const better = (/** @type {Row[]} */ some) => betterThanDefault(choicesOf(some, settings.get(width)));
      const onOrAbove = (/** @type {Row[]} */ some) =>
        tally(groupBy(some, 'model').values(), (ofModel) => {
          const choices = better(ofModel);
          return choices && choices.length === 0;
        });
      const connected = ofWidth.filter(({ modules }) => modules !== kMisleading);
      const ours = choicesOf(tested(ofWidth), settings.get(width)).find(({ isDefault }) => isDefault);
      return {
        width,
        ours,
        onMean: better(tested(ofWidth)),
        tested: onOrAbove(tested(ofWidth)),
        testedOthers: onOrAbove(tested(connected)),
      };
    });
    if (byWidth.some(({ ours }) => !ours)) return [];
    const byMean = [
      ...new Set(byWidth.flatMap(({ onMean = [] }) => onMean.map(({ modules, finders }) => `${modules} ${finders}`))),
    ];
    const misleads = byMean.some((kind) => kind.startsWith(`${kMisleading} `));
    const widthsOf = (/** @type {string} */ kind) =>
      byWidth.filter(({ onMean = [] }) => onMean.some(({ modules, finders }) => `${modules} ${finders}` === kind));
    return [
      said('choiceReads', {
        list: byWidth.map(({ width, ours }) =>
          said('choiceReadsAt', {
            width: { number: width, digits: 1 },
            reads: Math.round(ours?.printed ?? NaN),
            depth: { number: ours?.depth_mm ?? NaN, digits: 2 },
          }),
        ),
      }),
      said('choiceFrontier', { list: byWidth.map(({ width, tested: test }) => at(width, test)) }),
      ...(misleads
        ? [said('choiceOthers', { list: byWidth.map(({ width, testedOthers }) => at(width, testedOthers)) })]
        : []),
      ...byMean.map((kind) => {
        const [modules, finders] = kind.split(' ');
        return said('choiceBetter', {
          pattern: name('pattern', modules),
          finders: name('finder', finders),
          list: widthsOf(kind).map(({ width }) => said('millimetres', { width: { number: width, digits: 1 } })),
        });
      }),
      ...(misleads ? [said('choiceWhy')] : []),
    ];
  },
};
