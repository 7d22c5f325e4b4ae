// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace qrelief {

/// Directions in which a floor looks for its horizon.
inline constexpr int kFloorDirections = 16;

/// Cells that a floor looks over, the same for all floors: step by step outwards, each in all directions. Where a
/// direction has ended its steps have no distance: perMm = 0.
struct FloorSteps {
  std::vector<std::int32_t> offset;  ///< of the cell in the grid, from the floor's own
  std::vector<float> perMm;          ///< 1 / distance of the border behind which it begins; falls along a direction
};

/// A fraction of the sky, and its change per mm of depth.
struct SkySeen {
  double fraction = 0, perMm = 0;
};

/// What a floor sees, see PocketSky. All directions are followed at once, in vectors, until no cell can rise over what
/// was passed in any of them.
/// @param own    depth of the floor's own cell in a grid of depths, mm, all ≥ 0; all cells of the steps are readable
/// @param depthMm  of the floor, in place of what the grid holds
SkySeen skySeenFrom(const float* own, float depthMm, const FloorSteps& steps);

}  // namespace qrelief
