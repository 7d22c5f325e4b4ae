// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace qrelief {

/// Number of directions in which a floor looks for its horizon.
inline constexpr int kFloorDirections = 16;

/// Paths from a floor outwards, cell by cell, the same for all floors. Row-major: a row for each step, a column for
/// each direction. Beyond the end of a direction perMm is 0.
struct FloorSteps {
  std::vector<std::int32_t> offset;  ///< offset of the cell in the grid from the floor's own
  std::vector<float> perMm;          ///< 1 / distance of the border where the cell begins; falls along a direction
};

/// Fraction of the sky that a floor sees, and its change per mm of depth.
struct SkySeen {
  double fraction = 0, perMm = 0;
};

/// Computes the fraction of the sky that a floor sees (see PocketSky). The vector code follows all directions at once
/// and stops when no farther cell can raise a horizon.
/// @param own      the floor's cell in a grid of depths, mm, all ≥ 0; every step must lead to a readable cell
/// @param depthMm  of the floor; replaces the depth in its cell
SkySeen skySeenFrom(const float* own, float depthMm, const FloorSteps& steps);

}  // namespace qrelief
