// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace qrelief {

/// Distance of neighbouring 32-bit coordinates beyond which they are visible, mm: a hundredth of a layer.
inline constexpr double kCoarseStepMm = 0.001;

/// Returns the distance of neighbouring 32-bit coordinates at this distance from the origin, mm, rounded up.
inline double floatStepMm(double farthestMm) { return farthestMm * std::numeric_limits<float>::epsilon(); }

}  // namespace qrelief
