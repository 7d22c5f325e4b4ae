// SPDX-License-Identifier: GPL-3.0-or-later
// Share of CarvedQR's pictures that each decoder decodes, by surface, light and tilt.
import { distinct } from './compare.js';
import { said } from './say.js';

/** @typedef {import('./table.js').Row} Row */
/** @typedef {import('./say.js').Said} Said */

/**
 * Columns and the pictures that they count.
 * @type {readonly { word: import('./say.js').Word, has: (row: Row) => boolean }[]}
 */
const kColumns = [
  { word: 'ratesDesigned', has: ({ surface }) => surface === 'designed' },
  { word: 'ratesPrinted', has: ({ surface }) => surface === 'printed' },
  { word: 'ratesSky', has: ({ light }) => light === 'sky' },
  { word: 'ratesLamp', has: ({ light }) => light === 'sky and lamp' },
  { word: 'ratesFront', has: ({ tilt_deg: tilt }) => tilt === 0 },
  { word: 'ratesTilted', has: ({ tilt_deg: tilt }) => tilt === 'up to 20' },
  { word: 'ratesSteep', has: ({ tilt_deg: tilt }) => tilt === 'up to 45' },
];

/** @param {Row[]} rows @param {string} column */
const sum = (rows, column) => rows.reduce((total, row) => total + row[column], 0);

/** @param {Row[]} rows */
const shareOf = (rows) => (100 * sum(rows, 'read')) / sum(rows, 'pictures');

/**
 * Returns each decoder's share of all its pictures.
 * @param {Row[]} rows  of the table carved_qr_rates
 * @returns {{ decoder: string, share: number }[]}  from the best to the worst; in %
 */
export const decoderShares = (rows) =>
  distinct(rows, 'decoder')
    .map((decoder) => ({ decoder, share: shareOf(rows.filter((row) => row.decoder === decoder)) }))
    .sort((a, b) => b.share - a.share);

/**
 * @param {Row[]} rows  of the table carved_qr_rates
 * @returns {{ head: Said[], body: Said[][], pictures: number, wrong: number }}  decoders from the best to the worst; in %
 */
export function decoderRates(rows) {
  const ofDecoder = (/** @type {string} */ decoder) => rows.filter((row) => row.decoder === decoder);
  const decoders = decoderShares(rows).map(({ decoder }) => decoder);
  return {
    head: [said('ratesDecoder'), ...kColumns.map(({ word }) => said(word))],
    body: decoders.map((decoder) => [
      said('asIs', { value: decoder }),
      ...kColumns.map(({ has }) => {
        const some = ofDecoder(decoder).filter(has);
        return some.length === 0 ? said('ratesNone') : said('percent', { value: Math.round(shareOf(some)) });
      }),
    ]),
    pictures: decoders.length > 0 ? sum(ofDecoder(decoders[0]), 'pictures') : 0,
    wrong: sum(rows, 'wrong'),
  };
}
