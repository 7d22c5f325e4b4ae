// SPDX-License-Identifier: GPL-3.0-or-later
// Every figure; study.html refers to them by name.
import { aside } from '../figures/aside.js';
import { contrastSweep } from '../figures/contrast_sweep.js';
import { defaultChoice } from '../figures/default_choice.js';
import { equalDepth } from '../figures/equal_depth.js';
import { frontierDesigned, frontierPrinted } from '../figures/frontier.js';
import { guaranteedSize } from '../figures/guaranteed_size.js';
import { lampDepths } from '../figures/lamp_depths.js';
import { lampStrengths } from '../figures/lamp_strengths.js';
import { leastModule } from '../figures/least_module.js';
import { lightAngles } from '../figures/light_angles.js';
import { lightErrors } from '../figures/light_errors.js';
import { methodDepths } from '../figures/method_depths.js';
import { paperModule } from '../figures/paper_module.js';
import { patternDepths } from '../figures/pattern_depths.js';
import { robustness } from '../figures/robustness.js';
import { searchTimes } from '../figures/search_times.js';
import { symbolFlips } from '../figures/symbol_flips.js';

/** @type {readonly import('./figure.js').Figure[]} */
export const kFigures = [
  leastModule,
  guaranteedSize,
  patternDepths,
  methodDepths,
  contrastSweep,
  paperModule,
  frontierPrinted,
  defaultChoice,
  frontierDesigned,
  equalDepth,
  searchTimes,
  lightErrors,
  lampDepths,
  lampStrengths,
  lightAngles,
  robustness,
  aside,
  symbolFlips,
];
