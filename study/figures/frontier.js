// SPDX-License-Identifier: GPL-3.0-or-later
// Decoded tries against depth, every method from shallow to deep.
import { distinct, frontierAt, groupBy, tally } from '../page/compare.js';
import { inOrder, kColours, series } from '../page/figure.js';
import { isForOneLamp, isOurs, kDefaultMethod, kPatternedFinders } from '../page/methods.js';
import { models, name, said } from '../page/say.js';
import { kNeeded, kTries } from '../page/tries.js';

/** @typedef {import('../page/table.js').Row} Row */
/** @typedef {import('../page/compare.js').Point} Point */

/** @type {Record<string, [colour: string, shape: string, dash: number[]]>} */
const kStyles = {
  'groove-2018': [kColours.olive, 'triangle-down', []],
  'self-shadow-2019': [kColours.purple, 'square', []],
  'one-light-2020': [kColours.orange, 'diamond', []],
  'papp-2022': [kColours.blue, 'circle', []],
  'papp-2022-whole-modules': [kColours.blue, 'square', [4, 3]],
  'tilted-2021': [kColours.teal, 'triangle-left', []],
  'wavy-2021': [kColours.teal, 'triangle-up', [2, 3]],
  'papp-2022-literal': [kColours.blue, 'diamond', [2, 3]],
  'papp-2022-literal-whole-modules': [kColours.blue, 'triangle-down', [1, 3]],
  'even-depth': [kColours.grey, 'cross', []],
  'ours-reading': [kColours.green, 'triangle-right', [2, 3]],
  'ours-one-light': [kColours.green, 'diamond', [1, 3]],
  'ours-for-design': [kColours.green, 'circle', [5, 3]],
  'ours-thick-plus': [kColours.green, 'triangle-up', [8, 3]],
  'ours-whole-modules': [kColours.green, 'square', [4, 3]],
  ours: [kColours.green, 'cross', []],
};
const kThin = 1.2,
  kThick = 2.6; // lines; the thick one is our default

/**
 * Returns a method's levels on one model.
 * @param {Row[]} ofModel
 * @param {string} method
 * @param {string} measure
 * @returns {Point[]}
 */
const levelsOf = (ofModel, method, measure) =>
  ofModel.filter((row) => row.method === method).map((row) => [row.depth_mm, row[measure]]);

/**
 * Returns the methods of others that decode more often than our default at no more depth.
 * @param {Row[]} ofModel      of the frontier
 * @param {Row | undefined} ours  our default there
 * @returns {string[] | undefined}  undefined if our default was not measured
 */
export function betterThanDefault(ofModel, ours) {
  if (!ours) return undefined;
  return distinct(ofModel, 'method').filter(
    (method) =>
      !isOurs(method) && (frontierAt(levelsOf(ofModel, method, 'printed'), ours.depth_mm) ?? -1) > ours.printed,
  );
}

/**
 * Returns the least mean depth at which a method decodes as printed, at one of its levels.
 * @param {Row[]} ofModel
 * @param {string} method
 */
export function leastDepthThatReads(ofModel, method) {
  const depths = ofModel.filter((row) => row.method === method && row.printed >= kNeeded).map((row) => row.depth_mm);
  return depths.length > 0 ? Math.min(...depths) : undefined;
}

/** @param {'designed' | 'printed'} measure @returns {import('../page/figure.js').Figure['draw']} */
const draw = (measure) => (rows, look) => {
  const deep = rows.filter((row) => row.depth_mm > 0); // 0 has no logarithm
  const { rows: values, order } = look.named(deep, { model: 'model', method: 'method' });
  const methods = inOrder(deep, 'method', 'method');
  const styles = methods.map((method) => kStyles[method] ?? [kColours.ink, 'circle', []]);
  const names = order('method');
  const columns = look.narrow ? 2 : 4;
  /** @type {any} */
  const at = {
    x: {
      field: 'depth_mm',
      type: 'quantitative',
      title: look.word('axisDepth'),
      scale: { type: 'log', nice: false },
      axis: { values: [0.1, 0.2, 0.5, 1, 2], grid: false },
    },
    y: {
      field: measure,
      type: 'quantitative',
      title: look.word('axisReads', { of: kTries }),
      scale: { domain: [0, kTries] },
      axis: { values: [0, 20, 40, 60] },
    },
    order: { field: 'level' },
  };
  return {
    data: { values },
    columns,
    facet: { field: 'model', type: 'nominal', sort: order('model') },
    spec: {
      width: look.plotWidth(columns),
      height: 150,
      layer: [
        { mark: { type: 'rule', strokeDash: [5, 4], color: kColours.soft }, encoding: { y: { datum: kNeeded } } },
        ...methods.map((method, index) => ({
          transform: [{ filter: { field: 'method', equal: names[index] } }],
          mark: {
            type: /** @type {const} */ ('line'),
            color: styles[index][0],
            strokeDash: styles[index][2],
            strokeWidth: method === kDefaultMethod ? kThick : kThin,
          },
          encoding: at,
        })),
        {
          mark: { type: 'point', filled: true, size: 26, opacity: 1 },
          encoding: {
            ...at,
            ...series(
              'method',
              names,
              styles.map(([colour]) => colour),
              styles.map(([, shape]) => shape),
            ),
          },
        },
      ],
    },
  };
};

/** @type {import('../page/figure.js').Figure} */
export const frontierPrinted = {
  name: 'frontierPrinted',
  table: 'frontier',
  measures: ['depth_mm', 'printed'],
  draw: draw('printed'),
  find: (rows, { method_comparison: comparison = [] }) => {
    const ours = new Map(comparison.filter(({ method }) => method === kDefaultMethod).map((row) => [row.model, row]));
    const beaten = [...groupBy(rows, 'model')].map(([model, ofModel]) => betterThanDefault(ofModel, ours.get(model)));
    const onOrAbove = tally(beaten, (by) => by?.every(isForOneLamp));
    const byLamp = tally(beaten, (by) => by?.includes('one-light-2020'));
    const lost = [...new Set(beaten.flatMap((by) => by ?? []))]
      .filter((method) => !isForOneLamp(method))
      .map((method) =>
        said('frontierBy', {
          method: name('method', method),
          cases: models(tally(beaten, (by) => by?.includes(method))),
        }),
      );
    const shallowest = tally(groupBy(rows, 'model').values(), (ofModel) => {
      const least = (/** @type {boolean} */ ours) =>
        Math.min(
          ...distinct(ofModel, 'method')
            .filter((method) => !isForOneLamp(method) && isOurs(method) === ours)
            .map((method) => leastDepthThatReads(ofModel, method) ?? Infinity),
        );
      return Math.min(least(true), least(false)) === Infinity ? undefined : least(true) <= least(false);
    });
    const patterned = tally(groupBy(rows, 'model'), ([model, ofModel]) => {
      const usual = ours.get(model),
        reads = usual && frontierAt(levelsOf(ofModel, kPatternedFinders, 'printed'), usual.depth_mm);
      return usual && reads !== undefined ? usual.printed >= reads : undefined;
    });
    return [
      said('frontierDefault', { cases: models(onOrAbove) }),
      ...(patterned.of > 0 ? [said('frontierFinders', { cases: models(patterned) })] : []),
      said('frontierLost', { list: lost }),
      ...(rows.some(({ method }) => method === 'one-light-2020')
        ? [said('frontierLamp', { cases: models(byLamp) })]
        : []),
      said('frontierShallowest', { cases: models(shallowest), needed: kNeeded, tries: kTries }),
      said('frontierPaper'),
    ];
  },
};

/** @type {import('../page/figure.js').Figure} */
export const frontierDesigned = {
  name: 'frontierDesigned',
  table: 'frontier',
  measures: ['depth_mm', 'designed'],
  draw: draw('designed'),
  find: (rows) => {
    const lost = tally(
      rows.filter(({ designed }) => designed >= kNeeded),
      ({ printed }) => printed < kNeeded,
    );
    return [said('frontierLostInPrint', { holds: lost.holds, of: lost.of })];
  },
};
