// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the study's figures, a file for each, with sentences that the build chooses according to the data
// (study/figures).
import { aside } from './figures/aside.js';
import { axes } from './figures/axes.js';
import { claims } from './figures/claims.js';
import { common } from './figures/common.js';
import { contrastSweep } from './figures/contrast_sweep.js';
import { decoderRates } from './figures/decoder_rates.js';
import { defaultChoice } from './figures/default_choice.js';
import { equalDepth } from './figures/equal_depth.js';
import { findings } from './figures/findings.js';
import { frontier } from './figures/frontier.js';
import { gallery } from './figures/gallery.js';
import { guaranteedSize } from './figures/guaranteed_size.js';
import { lampDepths } from './figures/lamp_depths.js';
import { lampStrengths } from './figures/lamp_strengths.js';
import { leastModule } from './figures/least_module.js';
import { lightAngles } from './figures/light_angles.js';
import { lightErrors } from './figures/light_errors.js';
import { methodDepths } from './figures/method_depths.js';
import { names } from './figures/names.js';
import { paperModule } from './figures/paper_module.js';
import { patternDepths } from './figures/pattern_depths.js';
import { robustness } from './figures/robustness.js';
import { searchTimes } from './figures/search_times.js';
import { symbolFlips } from './figures/symbol_flips.js';

export const figures = {
  en: {
    ...names.en,
    ...axes.en,
    ...common.en,
    ...findings.en,
    ...leastModule.en,
    ...guaranteedSize.en,
    ...patternDepths.en,
    ...methodDepths.en,
    ...frontier.en,
    ...equalDepth.en,
    ...searchTimes.en,
    ...lightErrors.en,
    ...lampDepths.en,
    ...lightAngles.en,
    ...robustness.en,
    ...aside.en,
    ...lampStrengths.en,
    ...contrastSweep.en,
    ...paperModule.en,
    ...defaultChoice.en,
    ...claims.en,
    ...decoderRates.en,
    ...gallery.en,
    ...symbolFlips.en,
  },
  de: {
    ...names.de,
    ...axes.de,
    ...common.de,
    ...findings.de,
    ...leastModule.de,
    ...guaranteedSize.de,
    ...patternDepths.de,
    ...methodDepths.de,
    ...frontier.de,
    ...equalDepth.de,
    ...searchTimes.de,
    ...lightErrors.de,
    ...lampDepths.de,
    ...lightAngles.de,
    ...robustness.de,
    ...aside.de,
    ...lampStrengths.de,
    ...contrastSweep.de,
    ...paperModule.de,
    ...defaultChoice.de,
    ...claims.de,
    ...decoderRates.de,
    ...gallery.de,
    ...symbolFlips.de,
  },
};
