// SPDX-License-Identifier: GPL-3.0-or-later
// Time of each method's depth search.
import { distinct } from '../page/compare.js';
import { kPublished } from '../page/methods.js';
import { name, said } from '../page/say.js';
import { methodStrips } from '../page/strips.js';
import { typical } from './method_depths.js';

/** @typedef {import('../page/table.js').Row} Row */

/** Returns seconds; median over the models. @param {Row[]} rows @param {string} method */
export const secondsOf = (rows, method) => typical(rows, method, 'search_ms') / 1000;

/** @param {number} seconds */
const written = (seconds) => ({ number: seconds, digits: seconds < 1 ? 2 : seconds < 10 ? 1 : 0 });

/** @type {import('../page/figure.js').Figure} */
export const searchTimes = {
  name: 'searchTimes',
  table: 'method_comparison',
  measures: ['search_ms'],
  draw: (rows, look) => {
    const timed = rows.filter((row) => row.search_ms > 0).map((row) => ({ ...row, seconds: row.search_ms / 1000 }));
    return methodStrips(timed, look, [{ measure: 'seconds', title: look.word('axisSeconds'), log: true }]);
  },
  find: (rows) => {
    const methods = distinct(rows, 'method')
      .map((method) => ({ method, seconds: secondsOf(rows, method) }))
      .sort((a, b) => a.seconds - b.seconds);
    const [fastest, slowest] = [methods[0], methods[methods.length - 1]];
    const [papp, shadow, light] = [kPublished, 'self-shadow-2019', 'one-light-2020'].map((method) =>
      secondsOf(rows, method),
    );
    return [
      said('timesRange', {
        fastest: name('method', fastest.method),
        least: written(fastest.seconds),
        slowest: name('method', slowest.method),
        most: written(slowest.seconds),
      }),
      said(Math.min(shadow, light) > papp ? 'timesPaperHolds' : 'timesPaperFails', {
        papp: written(papp),
        shadow: written(shadow),
        light: written(light),
      }),
      said('timesWhy'),
    ];
  },
};
