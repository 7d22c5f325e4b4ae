// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "study/carved_code.h"
#include "study/spot.h"

namespace qrelief::study {

/// Difference of two lights on the carved submodules: its mean, and the mean of its absolute value.
struct LightError {
  double mean = 0, meanSize = 0;
};

/// Traces the light on the carved submodules of a code, in the order of CarvedCode::ownEstimate; 1 = an unoccluded
/// surface. 64 paths a submodule, seed 1.
Result<std::vector<double>> tracedLuminance(const StudyPlacement& spot, const CarvedCode& code);

/// @param own, traced  of the same submodules
LightError lightErrorOf(std::span<const double> own, std::span<const double> traced);

}  // namespace qrelief::study
