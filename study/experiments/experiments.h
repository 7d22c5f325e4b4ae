// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "study/experiment.h"

namespace qrelief::study {

// Each has a file of its own, whose first comment says what it shows.
Experiment leastModule();
Experiment guaranteedSize();
Experiment randomSizes();
Experiment patternDepths();
Experiment methodComparison();
Experiment paperModule();
Experiment contrastSweep();
Experiment frontier();
Experiment equalDepth();
Experiment symbolFlips();
Experiment lampDepths();
Experiment lampStrengths();
Experiment lightAngles();
Experiment robustness();
Experiment defaultSpace();
Experiment defaultChoice();
Experiment defaultSettings();
Experiment hbaoLight();
Experiment literalParts();

}  // namespace qrelief::study
