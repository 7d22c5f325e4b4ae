// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

// Constants of the fast search, for its solver on the CPU (fast_search.h) and on the GPU (shader_search.h).

namespace qrelief {

inline constexpr double kFirstDepthModules = 0.25;
inline constexpr double kChangeFraction = 0.4;  ///< of a floor's last change of difference: extra darkness to aim at
inline constexpr double kMaxChange = 0.3;       ///< limit on the change that counts
inline constexpr int kFreePasses = 3, kFreePassesAfterAnother = 1;
/// Under lamps, a pass makes a floor deeper by at most this, or by this fraction of its depth.
inline constexpr double kLampStepMm = 0.1, kLampGrowth = 0.2;
/// Margin by which the search aims darker, as a fraction of the threshold, so that G ends at 0 or below.
inline constexpr double kAimFraction = 0.003;
inline constexpr double kMaxAimFraction = 0.2;

/// Returns the margin for floors that are too bright. It grows with the passes, because the few floors that stay too
/// bright are badly predicted by the plane.
inline double aimForTooBright(int iterations, int freePasses) {
  return std::min(kAimFraction * std::pow(3.0, std::max(0, iterations - freePasses + 1)), kMaxAimFraction);
}

/// Returns the first estimate of measured minus predicted darkness: interreflection.
inline double firstDifference(double albedo) {
  constexpr double kMaxAlbedo = 0.95;
  return std::log(1 - std::min(albedo, kMaxAlbedo));
}

}  // namespace qrelief
