// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/map_window.h"

#include <algorithm>
#include <cmath>

namespace qrelief {

MapWindow surroundingsOf(const MapWindow& map, const ProjectionFrame& frame, const Box3& model) {
  constexpr double kMaxMaps = 16;
  double reach = map.extentMm / 2;
  for (int k = 0; k < 8; ++k) {
    const Vec3 corner(k & 1 ? model.max.x : model.min.x, k & 2 ? model.max.y : model.min.y,
                      k & 4 ? model.max.z : model.min.z);
    // A corner level with the eye or behind it may appear in any direction: assume the widest window.
    const bool inFront = frame.distanceAlongAxis(corner) > frame.eyeDistance / 100;
    const Vec2 seen = inFront ? frame.project(corner) : Vec2(kMaxMaps * map.extentMm);
    reach = std::max({reach, std::abs(seen.x), std::abs(seen.y)});
  }
  return {2 * std::min(reach, kMaxMaps / 2 * map.extentMm), 256};
}

}  // namespace qrelief
