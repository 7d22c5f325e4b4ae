// SPDX-License-Identifier: GPL-3.0-or-later
// Every method with modules of 1.2 mm, the width of the paper's prints.
import { distinct, groupBy, tally } from '../page/compare.js';
import { isForOneLamp, isOurs, kDefaultMethod } from '../page/methods.js';
import { mm, models, name, said } from '../page/say.js';
import { methodStrips } from '../page/strips.js';
import { kTries } from '../page/tries.js';
import { typical } from './method_depths.js';

/** @typedef {import('../page/table.js').Row} Row */

/**
 * Returns the methods of others for the sky that decode more often than our default at no more depth.
 * @param {Row[]} ofModel
 * @returns {string[] | undefined}  undefined if our default was not measured
 */
export function betterThanDefault(ofModel) {
  const ours = ofModel.find(({ method }) => method === kDefaultMethod);
  return (
    ours &&
    ofModel
      .filter(
        ({ method, printed, depth_mm: depth }) =>
          !isOurs(method) && !isForOneLamp(method) && printed > ours.printed && depth <= ours.depth_mm,
      )
      .map(({ method }) => method)
  );
}

/** @type {import('../page/figure.js').Figure} */
export const paperModule = {
  name: 'paperModule',
  table: 'paper_module',
  measures: ['depth_mm', 'printed'],
  draw: (rows, look) =>
    methodStrips(rows, look, [
      { measure: 'depth_mm', title: look.word('axisDepth') },
      { measure: 'printed', title: look.word('axisReads', { of: kTries }) },
    ]),
  find: (rows) => {
    const others = distinct(rows, 'method').filter((method) => !isOurs(method) && !isForOneLamp(method));
    const reads = (/** @type {string} */ method) => Math.round(typical(rows, method, 'printed'));
    const onOrAbove = tally(groupBy(rows, 'model').values(), (ofModel) => {
      const better = betterThanDefault(ofModel);
      return better && better.length === 0;
    });
    return [
      said('paperModuleReads', { reads: reads(kDefaultMethod), depth: mm(typical(rows, kDefaultMethod, 'depth_mm')) }),
      said('paperModuleOthers', {
        list: others.map((method) =>
          said('paperModuleOther', {
            method: name('method', method),
            reads: reads(method),
            depth: mm(typical(rows, method, 'depth_mm')),
          }),
        ),
      }),
      said('paperModuleDefault', { cases: models(onOrAbove) }),
      said('methodsReading'),
    ];
  },
};
