// SPDX-License-Identifier: GPL-3.0-or-later
// Decoded tries at the default's depth, for several texts.
import { distinct, groupBy, median, tally } from '../page/compare.js';
import { isOurs, kDefaultMethod } from '../page/methods.js';
import { models, name, said } from '../page/say.js';
import { methodStrips } from '../page/strips.js';
import { kTries } from '../page/tries.js';

/** @typedef {import('../page/table.js').Row} Row */

/**
 * Returns the median of a method's decoded tries over the texts.
 * @param {Row[]} ofModel
 * @param {string} method
 * @returns {number}
 */
export const readsOf = (ofModel, method) =>
  median(ofModel.filter((row) => row.method === method).map(({ printed }) => printed));

/**
 * Returns the median of typical tries over the models that have rows of the method.
 * @param {Row[]} rows
 * @param {string} method
 * @returns {number}
 */
export const readsOverModels = (rows, method) =>
  median(
    [
      ...groupBy(
        rows.filter((row) => row.method === method),
        'model',
      ).values(),
    ].map((ofModel) => readsOf(ofModel, method)),
  );

/**
 * Returns the spread of one code's decoded tries over the texts: median over models and methods.
 * @param {Row[]} rows
 */
export const spreadOf = (rows) =>
  median(
    [...groupBy(rows, 'model').values()].flatMap((ofModel) =>
      [...groupBy(ofModel, 'method').values()].map(
        (of) => Math.max(...of.map(({ printed }) => printed)) - Math.min(...of.map(({ printed }) => printed)),
      ),
    ),
  );

/**
 * Returns the models with rows of every method, our default included, with every text; other models cannot compare
 * methods.
 * @param {Row[]} rows
 * @returns {Row[][]}  by model
 */
export function wholeModels(rows) {
  const each = distinct(rows, 'method').length * distinct(rows, 'text').length;
  return [...groupBy(rows, 'model').values()].filter(
    (ofModel) => ofModel.length === each && ofModel.some(({ method }) => method === kDefaultMethod),
  );
}

/** Returns the methods that decode more often than the default. @param {Row[]} ofModel @returns {string[]} */
export const oftener = (ofModel) =>
  distinct(ofModel, 'method').filter((method) => readsOf(ofModel, method) > readsOf(ofModel, kDefaultMethod));

/** @type {import('../page/figure.js').Figure} */
export const equalDepth = {
  name: 'equalDepth',
  table: 'equal_depth',
  measures: ['depth_mm', 'printed'],
  draw: (rows, look) =>
    methodStrips(rows, look, [{ measure: 'printed', title: look.word('axisReads', { of: kTries }) }]),
  find: (rows) => {
    const ofModels = wholeModels(rows),
      compared = ofModels.flat();
    const holds = (/** @type {(method: string) => boolean} */ counts) =>
      models(tally(ofModels, (ofModel) => oftener(ofModel).filter(counts).length === 0));
    const others = distinct(compared, 'method').filter((method) => method !== kDefaultMethod);
    return [
      said('equalDepthOthers', { texts: distinct(compared, 'text').length, cases: holds((method) => !isOurs(method)) }),
      said('equalDepthList', {
        list: others.map((method) =>
          said('equalDepthBy', {
            method: name('method', method),
            cases: models(tally(ofModels, (ofModel) => oftener(ofModel).includes(method))),
            reads: { number: readsOverModels(compared, method), digits: 1 },
          }),
        ),
        reads: { number: readsOverModels(compared, kDefaultMethod), digits: 1 },
      }),
      said('equalDepthSpread', { spread: { number: spreadOf(compared), digits: 1 } }),
    ];
  },
};
