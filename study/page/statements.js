// SPDX-License-Identifier: GPL-3.0-or-later
// The statements of the paper's section 8 [Papp 2022], and how often each holds in our tables.
import { gainsAtPlaces } from '../figures/guaranteed_size.js';
import { lampsDeepen, lampsMakeShallower } from '../figures/lamp_depths.js';
import { asSmallIfBothRead, wholeAsSmallAsModules, wholeAsSmallAsOwn } from '../figures/least_module.js';
import { bearsHigher, carving, kPaper, lowerNeverHurts, tolerates } from '../figures/light_angles.js';
import { isPaperOrder, oneLightOfSelfShadows, wholeIsAsSelfShadows } from '../figures/method_depths.js';
import {
  findersLowerDepth,
  looseAreShallowest,
  patternsAreShallower,
  squareFromDiamond,
  thickPlusIsDeepest,
  thinPlusIsShallowest,
} from '../figures/pattern_depths.js';
import { byPattern, moreCarvedSurvivesMore } from '../figures/robustness.js';
import { secondsOf } from '../figures/search_times.js';
import { groupBy, onModels, tally } from './compare.js';
import { kPublished, ofSearch } from './methods.js';
import { kNeeded } from './tries.js';

/** @typedef {import('./table.js').Row} Row */
/** @typedef {import('./compare.js').Tally} Tally */
/**
 * @typedef {object} Statement
 * @property {import('./say.js').Word} claim   the paper's statement
 * @property {string} section                  id of the figure's section in study.html
 * @property {string} table
 * @property {'models' | 'cases'} over         what is counted
 * @property {boolean} [hasSearch]             it is about the paper's search of depths, so both readings are judged
 * @property {(rows: Row[], search?: string) => Tally} judge  how often it holds, by a reading of the paper's search
 * @property {import('./say.js').Word} [why]   the likely reason where it does not hold, or cannot be judged
 */

const kFlatModels = ['plate', 'pyramid']; // where curvature is zero
const kSizeFraction = 0.02;
const kHalfWithin = 0.1;

/**
 * Counts the paper's lamps for which codes that are engraved for them fulfil a condition.
 * @param {Row[]} rows  of light_angles
 * @param {string | undefined} search
 * @param {string} modules
 * @param {(ofLamp: Row[], lamp: typeof kPaper[number]) => boolean} judge
 */
const ofLamps = (rows, search, modules, judge) =>
  tally(kPaper, (lamp) => {
    const ofLamp = carving(ofSearch(rows, search), modules, lamp.carvedAt);
    return ofLamp.length > 0 ? judge(ofLamp, lamp) : undefined;
  });

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
    judge: wholeAsSmallAsModules,
    why: 'claimWhySteps',
  },
  {
    claim: 'claimFinderOwn',
    section: 'module',
    table: 'least_module',
    over: 'cases',
    judge: wholeAsSmallAsOwn,
    why: 'claimWhyStanding',
  },
  {
    claim: 'claimSize',
    section: 'size',
    table: 'random_sizes',
    over: 'cases',
    judge: (rows) => tally(gainsAtPlaces(rows), (gain) => gain >= kSizeFraction),
    why: 'claimWhyPlaces',
  },
  {
    claim: 'claimShallower',
    section: 'patterns',
    table: 'pattern_depths',
    over: 'models',
    hasSearch: true,
    judge: (rows, search) => onModels(ofSearch(rows, search), patternsAreShallower),
  },
  {
    claim: 'claimLoose',
    section: 'patterns',
    table: 'pattern_depths',
    over: 'models',
    hasSearch: true,
    judge: (rows, search) => onModels(ofSearch(rows, search), (ofModel) => looseAreShallowest(ofModel)),
  },
  {
    claim: 'claimThinPlus',
    section: 'patterns',
    table: 'pattern_depths',
    over: 'models',
    hasSearch: true,
    judge: (rows, search) => onModels(ofSearch(rows, search), thinPlusIsShallowest),
  },
  {
    claim: 'claimThickPlus',
    section: 'patterns',
    table: 'pattern_depths',
    over: 'models',
    hasSearch: true,
    judge: (rows, search) => onModels(ofSearch(rows, search), thickPlusIsDeepest),
  },
  {
    claim: 'claimGap',
    section: 'patterns',
    table: 'pattern_depths',
    over: 'models',
    hasSearch: true,
    judge: (rows, search) => {
      const ofOne = groupBy(ofSearch(rows, search), 'model');
      const flat = squareFromDiamond(ofOne.get('plate') ?? []);
      return tally(ofOne, ([model, ofModel]) => {
        const curved = squareFromDiamond(ofModel);
        return kFlatModels.includes(model) || flat === undefined || curved === undefined ? undefined : curved < flat;
      });
    },
  },
  {
    claim: 'claimFinders',
    section: 'patterns',
    table: 'pattern_depths',
    over: 'cases',
    hasSearch: true,
    judge: (rows, search) => findersLowerDepth(ofSearch(rows, search)),
  },
  {
    claim: 'claimFindersUnread',
    section: 'patterns',
    table: 'pattern_depths',
    over: 'cases',
    hasSearch: true,
    judge: (rows, search) =>
      tally(
        ofSearch(rows, search).filter(({ modules, finders }) => modules !== 'none' && finders === 'as-modules'),
        ({ designed }) => designed < kNeeded,
      ),
    why: 'claimWhyThickRead',
  },
  {
    claim: 'claimOrder',
    section: 'methods',
    table: 'method_comparison',
    over: 'models',
    hasSearch: true,
    judge: (rows, search) => onModels(rows, (ofModel) => isPaperOrder(ofModel, search)),
    why: 'claimWhyDarkness',
  },
  {
    claim: 'claimHalf',
    section: 'methods',
    table: 'method_comparison',
    over: 'models',
    judge: (rows) =>
      onModels(rows, (ofModel) => {
        const fraction = oneLightOfSelfShadows(ofModel);
        return fraction === undefined ? undefined : Math.abs(fraction - 0.5) <= kHalfWithin;
      }),
  },
  {
    claim: 'claimWhole',
    section: 'methods',
    table: 'method_comparison',
    over: 'models',
    hasSearch: true,
    judge: (rows, search) => onModels(rows, (ofModel) => wholeIsAsSelfShadows(ofModel, search)),
    why: 'claimWhyDarkness',
  },
  {
    claim: 'claimTime',
    section: 'time',
    table: 'method_comparison',
    over: 'cases',
    hasSearch: true,
    judge: (rows, search = kPublished) =>
      tally(['self-shadow-2019', 'one-light-2020'], (method) => {
        const [papp, peng] = [secondsOf(rows, search), secondsOf(rows, method)];
        return Number.isFinite(papp) && Number.isFinite(peng) ? papp < peng : undefined;
      }),
  },
  {
    claim: 'claimLampPattern',
    section: 'lamps',
    table: 'lamp_depths',
    over: 'models',
    hasSearch: true,
    judge: (rows, search) => onModels(ofSearch(rows, search), (ofModel) => lampsDeepen(ofModel, 'square')),
    why: 'claimWhyElevation',
  },
  {
    claim: 'claimLampWhole',
    section: 'lamps',
    table: 'lamp_depths',
    over: 'models',
    hasSearch: true,
    judge: (rows, search) => onModels(ofSearch(rows, search), (ofModel) => lampsMakeShallower(ofModel, 'none')),
    why: 'claimWhyElevation',
  },
  {
    claim: 'claimLampsUnread',
    section: 'angles',
    table: 'light_angles',
    over: 'cases',
    hasSearch: true,
    judge: (rows, search) => ofLamps(rows, search, 'square', (ofLamp, { carvedAt }) => !tolerates(ofLamp, carvedAt, 0)),
    why: 'claimWhySquareRead',
  },
  {
    claim: 'claimAngles',
    section: 'angles',
    table: 'light_angles',
    over: 'cases',
    hasSearch: true,
    judge: (rows, search) =>
      ofLamps(rows, search, 'none', (ofLamp, { carvedAt, higher }) => tolerates(ofLamp, carvedAt, higher)),
    why: 'claimWhyAngles',
  },
  {
    claim: 'claimLowerLamp',
    section: 'angles',
    table: 'light_angles',
    over: 'cases',
    hasSearch: true,
    judge: (rows, search) => ofLamps(rows, search, 'none', (ofLamp, { carvedAt }) => lowerNeverHurts(ofLamp, carvedAt)),
    why: 'claimWhyLowerLamp',
  },
  {
    claim: 'claimHigherLamp',
    section: 'angles',
    table: 'light_angles',
    over: 'cases',
    hasSearch: true,
    judge: (rows, search) => {
      const [high, low] = kPaper.map(({ carvedAt }) => {
        const ofLamp = carving(ofSearch(rows, search), 'none', carvedAt);
        return ofLamp.length > 0 ? { depth: ofLamp[0].depth_mm, bears: bearsHigher(ofLamp, carvedAt) } : undefined;
      });
      return tally([0], () => (high && low ? high.depth > low.depth && high.bears > low.bears : undefined));
    },
  },
  {
    claim: 'claimRobust',
    section: 'robust',
    table: 'robustness',
    over: 'cases',
    hasSearch: true,
    judge: (rows, search) => moreCarvedSurvivesMore(byPattern(rows, 'blur_modules', search)),
    why: 'claimWhySmallLosses',
  },
];
