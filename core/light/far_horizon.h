// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "light/directional_light.h"
#include "light/height_map.h"

namespace qrelief {

/// Horizon of the uncarved surface beyond a distance, on a coarse grid of places: it marks the sky that the body itself
/// hides.
struct FarHorizon {
  static constexpr int kDirections = 16;  ///< anticlockwise from the map's right

  int places = 0;  ///< along the map's edge
  /// Cotangents of the angle between the line of sight and the horizon, by direction, then by place, row-major from the
  /// lower left. Never below the surface's own plane. The lamps follow the directions; their horizons ignore that
  /// plane, because each patch of a place has its own angle to a lamp.
  std::vector<float> cotangents;

  bool hasLamps() const {
    return cotangents.size() > static_cast<std::size_t>(kDirections) * static_cast<std::size_t>(places * places);
  }
};

/// Finds the far horizon of a surface.
/// Cost: places² · 16 steps of growing length, up to the edge of `around`; for each lamp about as many again.
/// @param map      the uncarved surface around the code
/// @param around   the surroundings from the same eye, in a wider window with larger patches; null: there are none
/// @param startMm  nearer surface is ignored, > 0
/// @param lamps    find the horizon towards each of them, too, by finer steps: at most kMaxLights
FarHorizon farHorizonOf(const HeightMap& map, const HeightMap* around, double startMm, int places,
                        std::span<const DirectionalLight> lamps = {});

}  // namespace qrelief
