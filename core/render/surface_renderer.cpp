// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface_renderer.h"

#include <algorithm>
#include <cmath>

namespace qrelief {

std::vector<float> rayDistances(const std::vector<float>& surface, const ProjectionFrame& frame,
                                const MapWindow& window) {
  std::vector<float> distances(surface.size() / 4, 0.0f);
  for (int row = 0; row < window.texels; ++row) {
    for (int column = 0; column < window.texels; ++column) {
      const auto texel = static_cast<std::size_t>(row * window.texels + column);
      const float* const values = &surface[4 * texel];
      if (values[0] == 0 && values[1] == 0 && values[2] == 0) continue;
      const double onPlane = glm::length(Vec3(window.planePoint(column, row), frame.eyeDistance));
      distances[texel] = static_cast<float>(onPlane * (1 - static_cast<double>(values[3]) / frame.eyeDistance));
    }
  }
  return distances;
}

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
