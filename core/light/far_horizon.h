// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "light/height_map.h"

namespace qrelief {

/// Horizon of the uncarved surface beyond a distance, on a coarse grid of places: it marks the sky that the body itself
/// hides.
struct FarHorizon {
  static constexpr int kDirections = 16;  ///< anticlockwise from the map's right

  int places = 0;  ///< along the map's edge
  /// Cotangents of the angle between the line of sight and the horizon, by direction, then by place, row-major from the
  /// lower left. Never below the surface's own plane.
  std::vector<float> cotangents;
};

/// Finds the far horizon of a surface.
/// Cost: places² · 16 steps of growing length, up to the edge of `around`.
/// @param map      the uncarved surface around the code
/// @param around   the surroundings from the same eye, in a wider window with larger patches; null: there are none
/// @param startMm  nearer surface is ignored, > 0
FarHorizon farHorizonOf(const HeightMap& map, const HeightMap* around, double startMm, int places);

}  // namespace qrelief
