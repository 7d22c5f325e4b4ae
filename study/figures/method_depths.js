// SPDX-License-Identifier: GPL-3.0-or-later
// Depth by method, each at the contrast of its authors’ program, or ours if they publish none [Papp 2022, figure 20].
import { distinct, groupBy, median, onModels, rises, tally, valuesBy } from '../page/compare.js';
import { kLiteral, kPublished } from '../page/methods.js';
import { mm, models, name, said } from '../page/say.js';
import { methodStrips } from '../page/strips.js';
import { kNeeded } from '../page/tries.js';

/** @typedef {import('../page/table.js').Row} Row */

const kAlikeFraction = 0.25;

/**
 * True if the paper's order holds: one lamp of 2020, then its own patterns, then self-shadows of 2019.
 * @param {Row[]} ofModel
 * @param {string} [search]  a reading of the paper's search
 */
export function isPaperOrder(ofModel, search = kPublished) {
  const depths = valuesBy(ofModel, 'method', 'depth_mm');
  return rises([depths['one-light-2020'], depths[search], depths['self-shadow-2019']]);
}

/**
 * Returns the depth of one lamp of 2020 as a fraction of the depth of self-shadows of 2019.
 * @param {Row[]} ofModel
 * @returns {number | undefined}
 */
export function oneLightOfSelfShadows(ofModel) {
  const { 'one-light-2020': light, 'self-shadow-2019': shadow } = valuesBy(ofModel, 'method', 'depth_mm');
  return light === undefined || shadow === undefined ? undefined : light / shadow;
}

/**
 * Returns the depth of the whole modules of 2019 in multiples of the paper's.
 * @param {Row[]} ofModel
 * @param {string} [search]  a reading of the paper's search
 * @returns {number | undefined}
 */
export function selfShadowsTimesWhole(ofModel, search = kPublished) {
  const { 'self-shadow-2019': peng, [`${search}-whole-modules`]: whole } = valuesBy(ofModel, 'method', 'depth_mm');
  return peng === undefined || whole === undefined ? undefined : peng / whole;
}

/** True if whole modules are about as deep as in 2019. @param {Row[]} ofModel @param {string} [search] */
export function wholeIsAsSelfShadows(ofModel, search = kPublished) {
  const times = selfShadowsTimesWhole(ofModel, search);
  return times === undefined ? undefined : Math.abs(Math.log(times)) <= Math.log(1 + kAlikeFraction);
}

/** Counts the models on which a method's codes decode as designed. @param {Row[]} rows @param {string} method */
export const readsAsDesigned = (rows, method) =>
  tally(
    rows.filter((row) => row.method === method),
    ({ designed }) => designed >= kNeeded,
  );

/** Returns a measure's median over the models. @param {Row[]} rows @param {string} method @param {string} measure */
export const typical = (rows, method, measure) =>
  median(rows.filter((row) => row.method === method && row[measure] !== null).map((row) => row[measure]));

/** @type {import('../page/figure.js').Figure} */
export const methodDepths = {
  name: 'methodDepths',
  table: 'method_comparison',
  measures: ['depth_mm', 'designed', 'printed'],
  draw: (rows, look) => methodStrips(rows, look, [{ measure: 'depth_mm', title: look.word('axisDepth') }]),
  find: (rows) => {
    const times = [...groupBy(rows, 'model').values()]
      .map((ofModel) => selfShadowsTimesWhole(ofModel))
      .filter((value) => value !== undefined);
    const halves = [...groupBy(rows, 'model').values()]
      .map(oneLightOfSelfShadows)
      .filter((value) => value !== undefined);
    const alike = onModels(rows, (ofModel) => wholeIsAsSelfShadows(ofModel));
    const depth = (/** @type {string} */ method) => mm(typical(rows, method, 'depth_mm'));
    const unread = distinct(rows, 'method').filter((method) => typical(rows, method, 'printed') < kNeeded);
    const order = onModels(rows, (ofModel) => isPaperOrder(ofModel));
    const limited = Math.min(
      ...rows.filter(({ method }) => method === `${kLiteral}-whole-modules`).map((row) => row.limited ?? 0),
    );
    const lamps = ['one-light-2020', 'ours-one-light'].map((method) => readsAsDesigned(rows, method));
    return [
      said('methodsOrder', {
        cases: models(order),
        light: depth('one-light-2020'),
        papp: depth('papp-2022'),
        shadow: depth('self-shadow-2019'),
      }),
      said('methodsHalf', {
        least: mm(Math.min(...halves)),
        middle: mm(median(halves)),
        most: mm(Math.max(...halves)),
      }),
      said('methodsWhole', {
        cases: models(alike),
        times: { number: median(times), digits: 1 },
        percent: 100 * kAlikeFraction,
      }),
      ...(alike.holds < alike.of || order.holds < order.of ? [said('methodsWhy')] : []),
      ...(lamps.some(({ holds, of }) => holds < of)
        ? [said('methodsLamp', { peng: models(lamps[0]), ours: models(lamps[1]) })]
        : []),
      said('methodsLiteral', { square: depth(kLiteral), whole: depth(`${kLiteral}-whole-modules`) }),
      ...(limited > 0 && Number.isFinite(limited) ? [said('methodsLiteralLimited', { least: limited })] : []),
      said('methodsReading'),
      unread.length > 0
        ? said('methodsUnread', { list: unread.map((method) => name('method', method)) })
        : said('methodsAllRead'),
    ];
  },
};
