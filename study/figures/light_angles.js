// SPDX-License-Identifier: GPL-3.0-or-later
// Decoded tries against the angle of the reading lamp, by the angle of the lamp in the request [Papp 2022, figure 22].
import { tally } from '../page/compare.js';
import { kColours, series } from '../page/figure.js';
import { ofSearch } from '../page/methods.js';
import { cases, said } from '../page/say.js';
import { kNeeded, kTries } from '../page/tries.js';

/** @typedef {import('../page/table.js').Row} Row */

/** Angles that the paper carved for, and how much higher its reading lamp may be, in degrees. */
export const kPaper = [
  { carvedAt: 33, higher: 30 },
  { carvedAt: 8, higher: 15 },
];

/** Returns the rows of one carving. @param {Row[]} rows @param {string} modules @param {number | string} carvedAt */
export const carving = (rows, modules, carvedAt) =>
  rows.filter((row) => row.modules === modules && row.carved_at === carvedAt);

/**
 * Returns the allowed positions of the reading lamp: runs of consecutive tried angles at which the code decodes.
 * @param {Row[]} rows  of one carving
 * @returns {number[][]}  in degrees
 */
export function readRuns(rows) {
  /** @type {number[][]} */ const runs = [[]];
  for (const { read_at: angle, reads } of [...rows].sort((a, b) => a.read_at - b.read_at)) {
    if (reads >= kNeeded) runs[runs.length - 1].push(angle);
    else runs.push([]);
  }
  return runs.filter(({ length }) => length > 0);
}

/**
 * True if the code decodes with the lamp that it was carved for, and with lamps up to `higher` degrees above it.
 * @param {Row[]} rows  of one carving
 * @param {number} carvedAt
 * @param {number} higher
 */
export const tolerates = (rows, carvedAt, higher) => {
  const tried = rows.filter((row) => row.read_at >= carvedAt && row.read_at <= carvedAt + higher);
  return tried.length > 0 && tried.every(({ reads }) => reads >= kNeeded);
};

/** True if the code decodes with every lower lamp. @param {Row[]} rows  of one carving @param {number} carvedAt */
export const lowerNeverHurts = (rows, carvedAt) =>
  rows.filter((row) => row.read_at < carvedAt).every(({ reads }) => reads >= kNeeded);

/**
 * Returns how much higher than its own lamp a lamp may be, in degrees, of the lamps tried; below 0 if the code does not
 * decode under its own.
 * @param {Row[]} rows  of one carving
 * @param {number} carvedAt
 */
export const bearsHigher = (rows, carvedAt) =>
  Math.max(
    -1,
    ...rows
      .map(({ read_at: angle }) => angle - carvedAt)
      .filter((higher) => higher >= 0 && tolerates(rows, carvedAt, higher)),
  );

/** @param {Row[]} rows  of one carving */
function spans(rows) {
  const runs = readRuns(rows);
  return runs.length === 0
    ? said('anglesNone')
    : said('anglesWith', {
        list: runs.map((run) => said('anglesFromTo', { from: run[0], to: run[run.length - 1], count: run.length })),
      });
}

/** @type {import('../page/figure.js').Figure} */
export const lightAngles = {
  name: 'lightAngles',
  table: 'light_angles',
  measures: ['reads'],
  draw: (rows, look) => {
    const { rows: values, order } = look.named(ofSearch(rows), { modules: 'pattern', carved_at: 'carvedAt' });
    const columns = look.narrow ? 1 : 2;
    return {
      data: { values },
      columns,
      facet: { field: 'modules', type: 'nominal', sort: order('modules') },
      spec: {
        width: look.plotWidth(columns),
        height: 170,
        layer: [
          { mark: { type: 'rule', strokeDash: [5, 4], color: kColours.soft }, encoding: { y: { datum: kNeeded } } },
          {
            mark: { type: 'line', point: { size: 44 }, strokeWidth: 2 },
            encoding: {
              x: {
                field: 'read_at',
                type: 'quantitative',
                title: look.word('axisLamp'),
                scale: { domain: [0, 90] },
                axis: { values: [0, 15, 30, 45, 60, 75, 90], grid: false },
              },
              y: {
                field: 'reads',
                type: 'quantitative',
                title: look.word('axisReads', { of: kTries }),
                scale: { domain: [0, kTries], nice: false },
                axis: { values: [0, 20, 40, 60] },
              },
              ...series(
                'carved_at',
                order('carved_at'),
                [kColours.grey, kColours.orange, kColours.blue],
                ['circle', 'square', 'triangle-up'],
              ),
            },
          },
        ],
      },
    };
  },
  find: (all) => {
    const rows = ofSearch(all);
    const whole = kPaper.map(({ carvedAt, higher }) => ({ carvedAt, higher, rows: carving(rows, 'none', carvedAt) }));
    if (whole.some(({ rows: { length } }) => length === 0)) return [];
    const [one, other] = whole;
    return [
      said('anglesWhole', {
        oneAt: one.carvedAt,
        one: spans(one.rows),
        otherAt: other.carvedAt,
        other: spans(other.rows),
      }),
      said('anglesPaper', {
        oneHigher: one.higher,
        otherHigher: other.higher,
        onePaper: 90 + one.carvedAt,
        otherPaper: 90 + other.carvedAt,
        higher: cases(tally(whole, ({ carvedAt, higher, rows: ofOne }) => tolerates(ofOne, carvedAt, higher))),
        lower: cases(tally(whole, ({ carvedAt, rows: ofOne }) => lowerNeverHurts(ofOne, carvedAt))),
        own: cases(tally(whole, ({ carvedAt, rows: ofOne }) => tolerates(ofOne, carvedAt, 0))),
      }),
      said('anglesPattern', {
        one: spans(carving(rows, 'square', one.carvedAt)),
        other: spans(carving(rows, 'square', other.carvedAt)),
      }),
      said('anglesWhy'),
    ];
  },
};
