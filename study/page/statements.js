// SPDX-License-Identifier: GPL-3.0-or-later
// The statements of the paper's section 8 [Papp 2022], and how often each holds in our tables.
import { sizesOverModels } from '../figures/guaranteed_size.js';
import { lampsDeepen, lampsMakeShallower } from '../figures/lamp_depths.js';
import { asSmall, asSmallIfBothRead } from '../figures/least_module.js';
import { carving, kPaper, tolerates } from '../figures/light_angles.js';
import { isPaperOrder, wholeIsAsSelfShadows } from '../figures/method_depths.js';
import {
  findersLowerDepth,
  looseAreShallowest,
  thickPlusIsDeepest,
  thinPlusIsShallowest,
} from '../figures/pattern_depths.js';
import { byPattern, moreCarvedSurvivesMore } from '../figures/robustness.js';
import { secondsOf } from '../figures/search_times.js';
import { groupBy, onModels, tally } from './compare.js';
import { kNeeded } from './tries.js';

/** @typedef {import('./table.js').Row} Row */
/** @typedef {import('./compare.js').Tally} Tally */
/**
 * @typedef {object} Statement
 * @property {import('./say.js').Word} claim   the paper's statement
 * @property {string} section                  id of the figure's section in study.html
 * @property {string} table
 * @property {'models' | 'cases'} over         what is counted
 * @property {(rows: Row[]) => Tally} judge    how often it holds
 * @property {import('./say.js').Word} [why]   the likely reason where it does not hold, or cannot be judged
 */

const kFlatModels = ['plate', 'pyramid']; // where depth makes no difference
const kSizeFraction = 0.02;

/** @type {readonly Statement[]} */
export const kStatements = [
  {
    claim: 'claimThickModule',
    section: 'module',
    table: 'least_module',
    over: 'cases',
    judge: (rows) => asSmallIfBothRead(rows, 'modules', 'thick-plus', 'thin-plus'),
    why: 'claimWhyThinUnread',
  },
  {
    claim: 'claimFinderModule',
    section: 'module',
    table: 'least_module',
    over: 'cases',
    judge: (rows) => asSmall(rows, 'finders', 'none', 'as-modules'),
    why: 'claimWhySteps',
  },
  {
    claim: 'claimSize',
    section: 'size',
    table: 'guaranteed_size',
    over: 'models',
    judge: (rows) =>
      sizesOverModels(
        rows.filter(({ model }) => !kFlatModels.includes(model)),
        kSizeFraction,
      ),
    why: 'claimWhyPlaces',
  },
  {
    claim: 'claimLoose',
    section: 'patterns',
    table: 'pattern_depths',
    over: 'models',
    judge: (rows) => onModels(rows, (ofModel) => looseAreShallowest(ofModel)),
  },
  {
    claim: 'claimThinPlus',
    section: 'patterns',
    table: 'pattern_depths',
    over: 'models',
    judge: (rows) => onModels(rows, thinPlusIsShallowest),
  },
  {
    claim: 'claimThickPlus',
    section: 'patterns',
    table: 'pattern_depths',
    over: 'models',
    judge: (rows) => onModels(rows, thickPlusIsDeepest),
  },
  { claim: 'claimFinders', section: 'patterns', table: 'pattern_depths', over: 'cases', judge: findersLowerDepth },
  {
    claim: 'claimFindersUnread',
    section: 'patterns',
    table: 'pattern_depths',
    over: 'cases',
    judge: (rows) =>
      tally(
        rows.filter(({ modules, finders }) => modules !== 'none' && finders === 'as-modules'),
        ({ designed }) => designed < kNeeded,
      ),
    why: 'claimWhyThickRead',
  },
  {
    claim: 'claimOrder',
    section: 'methods',
    table: 'method_comparison',
    over: 'models',
    judge: (rows) => onModels(rows, isPaperOrder),
    why: 'claimWhyDarkness',
  },
  {
    claim: 'claimWhole',
    section: 'methods',
    table: 'method_comparison',
    over: 'models',
    judge: (rows) => onModels(rows, wholeIsAsSelfShadows),
    why: 'claimWhyDarkness',
  },
  {
    claim: 'claimTime',
    section: 'time',
    table: 'method_comparison',
    over: 'cases',
    judge: (rows) =>
      tally(['self-shadow-2019', 'one-light-2020'], (method) => {
        const [papp, peng] = [secondsOf(rows, 'papp-2022'), secondsOf(rows, method)];
        return Number.isFinite(papp) && Number.isFinite(peng) ? papp < peng : undefined;
      }),
  },
  {
    claim: 'claimLampPattern',
    section: 'lamps',
    table: 'lamp_depths',
    over: 'models',
    judge: (rows) => onModels(rows, (ofModel) => lampsDeepen(ofModel, 'square')),
    why: 'claimWhyElevation',
  },
  {
    claim: 'claimLampWhole',
    section: 'lamps',
    table: 'lamp_depths',
    over: 'models',
    judge: (rows) => onModels(rows, (ofModel) => lampsMakeShallower(ofModel, 'none')),
    why: 'claimWhyElevation',
  },
  {
    claim: 'claimAngles',
    section: 'angles',
    table: 'light_angles',
    over: 'cases',
    judge: (rows) =>
      tally(kPaper, ({ carvedAt, higher }) => {
        const ofLamp = carving(rows, 'none', carvedAt);
        return ofLamp.length > 0 ? tolerates(ofLamp, carvedAt, higher) : undefined;
      }),
    why: 'claimWhyAngles',
  },
  {
    claim: 'claimRobust',
    section: 'robust',
    table: 'robustness',
    over: 'cases',
    judge: (rows) =>
      groupBy(rows, 'modules').size > 1 ? moreCarvedSurvivesMore(byPattern(rows, 'blur_modules')) : { holds: 0, of: 0 },
    why: 'claimWhySmallLosses',
  },
];
