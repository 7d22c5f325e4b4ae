// SPDX-License-Identifier: GPL-3.0-or-later
// The findings at the head of study.html: a number, what it says to somebody who prints codes, and bars.
import { decoderShares } from './decoder_rates.js';
import { distinct, median } from './compare.js';
import { isOurs, kDefaultMethod, ofSearch } from './methods.js';
import { mm, name, said } from './say.js';
import { kNeeded, kTries } from './tries.js';

/** @typedef {import('./table.js').Row} Row */
/** @typedef {import('./say.js').Said} Said */
/** @typedef {{ label: Said, value: number, said: Said, isOurs?: boolean }} Bar */
/**
 * @typedef {object} Finding
 * @property {import('./say.js').Word} title
 * @property {Said} number  the bars' most important value, with its unit
 * @property {Said[]} says
 * @property {Bar[]} bars
 * @property {number} [whole]  value of a bar of full length; default: the greatest
 */
/**
 * @typedef {object} FindingSource
 * @property {string} section  id in study.html of the figure behind it
 * @property {(rowsOf: Record<string, Row[]>) => Finding | undefined} find  undefined if its table is missing
 */

const kPoses = ['code-up', 'code-upright'];
const kProcesses = ['fdm-0.4/0.2', 'fdm-0.25/0.1'];

/** Returns the greatest angle up to which each angle from the lowest on decodes. @param {Row[]} rows by angle */
function readsUpTo(rows) {
  const fails = rows.findIndex(({ reads }) => reads < kNeeded);
  return fails < 0 ? rows.at(-1) : rows[fails - 1];
}

/** @param {number} value */
const millimetres = (value) => said('findingMm', { value: mm(value) });

/** @param {number} reads */
const tries = (reads) => said('findingTries', { reads: Math.round(reads), of: kTries });

/** @param {Row[]} rows @param {string} method @param {string} measure */
const medianOf = (rows, method, measure) =>
  median(rows.filter((row) => row.method === method).map((row) => row[measure]));

/** @type {readonly FindingSource[]} */
export const kFindings = [
  {
    section: 'module',
    find: ({ least_module: rows = [], default_settings: settings = [] }) => {
      const usual = settings[0]; // of the smallest modules
      const bars = kProcesses.flatMap((process) =>
        kPoses.flatMap((pose) => {
          const value = rows.find(
            (row) =>
              row.process === process &&
              row.pose === pose &&
              row.modules === usual?.modules &&
              row.finders === usual?.finders,
          )?.module_mm;
          const label = said('printAs', { process: name('process', process), pose: name('pose', pose) });
          return value ? [{ label, value, said: millimetres(value) }] : [];
        }),
      );
      if (bars.length < kProcesses.length * kPoses.length) return undefined;
      return {
        title: 'findingModule',
        number: millimetres(Math.max(...bars.map(({ value }) => value))),
        says: [said('findingModuleSays')],
        bars,
      };
    },
  },
  {
    section: 'methods',
    find: ({ method_comparison: rows = [] }) => {
      const bars = distinct(rows, 'method')
        .filter((method) => method === kDefaultMethod || !isOurs(method))
        .filter((method) => rows.every((row) => row.method !== method || row.printed >= kNeeded))
        .map((method) => ({ method, value: medianOf(rows, method, 'depth_mm') }))
        .sort((a, b) => a.value - b.value)
        .map(({ method, value }) => ({
          label: name('method', method),
          value,
          said: millimetres(value),
          isOurs: isOurs(method),
        }));
      const ours = bars.find((bar) => bar.isOurs);
      if (!ours) return undefined;
      return {
        title: 'findingDepth',
        number: ours.said,
        says: [said('findingDepthSays', { models: distinct(rows, 'model').length })],
        bars,
      };
    },
  },
  {
    section: 'frontier',
    find: ({ method_comparison: rows = [] }) => {
      const [designed, printed] = ['designed', 'printed'].map((measure) => medianOf(rows, kDefaultMethod, measure));
      if (Number.isNaN(designed)) return undefined;
      return {
        title: 'findingPrint',
        number: tries(printed),
        says: [said('findingPrintSays', { needed: kNeeded, of: kTries })],
        bars: [
          { label: said('findingDesigned'), value: designed, said: tries(designed) },
          { label: said('findingPrinted'), value: printed, said: tries(printed) },
        ],
        whole: kTries,
      };
    },
  },
  {
    section: 'angles',
    find: ({ light_angles: rows = [] }) => {
      const underSky = ofSearch(rows)
        .filter((row) => row.modules === 'none' && row.carved_at === 'sky')
        .sort((a, b) => a.read_at - b.read_at);
      const highest = readsUpTo(underSky);
      if (!highest) return undefined;
      return {
        title: 'findingLight',
        number: said('findingDegrees', { value: highest.read_at }),
        says: [said('findingLightSays', { needed: kNeeded, of: kTries })],
        bars: underSky.map(({ read_at: angle, reads }) => ({
          label: said('findingLampAt', { value: angle }),
          value: reads,
          said: tries(reads),
        })),
        whole: kTries,
      };
    },
  },
  {
    section: 'carvedQr',
    find: ({ carved_qr_rates: rows = [] }) => {
      const shares = decoderShares(rows);
      if (shares.length === 0) return undefined;
      const percent = (/** @type {number} */ value) => said('percent', { value: Math.round(value) });
      return {
        title: 'findingDecoders',
        number: said('findingRange', { from: percent(shares[shares.length - 1].share), to: percent(shares[0].share) }),
        says: [said('findingDecodersSays')],
        bars: shares.map(({ decoder, share }) => ({
          label: said('asIs', { value: decoder }),
          value: share,
          said: percent(share),
        })),
        whole: 100,
      };
    },
  },
];
