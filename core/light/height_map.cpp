// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/height_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace qrelief {
namespace {

constexpr double kSteepest = 100;  // mm per mm: a steeper facet is seen edge-on

}  // namespace

HeightMap heightMapOf(std::span<const float> surface, int size, double patchMm, double eyeDistance) {
  const std::size_t count = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  assert(surface.size() == 4 * count);
  HeightMap map{size,
                patchMm,
                eyeDistance,
                std::vector<float>(count, HeightMap::kNothing),
                std::vector<float>(count, 0.0f),
                std::vector<float>(count, 0.0f)};
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 normal(surface[4 * i], surface[4 * i + 1], surface[4 * i + 2]);
    if (normal == Vec3(0)) continue;
    const double depth = eyeDistance - static_cast<double>(surface[4 * i + 3]);
    const auto column = static_cast<int>(i % static_cast<std::size_t>(size));
    const auto row = static_cast<int>(i / static_cast<std::size_t>(size));
    const Vec3 ray((column + 0.5 - size / 2.0) * patchMm, (row + 0.5 - size / 2.0) * patchMm, -eyeDistance);
    map.height[i] = static_cast<float>(eyeDistance * eyeDistance / depth - eyeDistance);
    // On the facet's plane the slope of w is eyeDistance·n / (k·n·ray), where k·ray leads from the eye to its point.
    const double facing = std::min(glm::dot(normal, ray) * depth / eyeDistance, -1e-9);
    map.slopeX[i] = static_cast<float>(std::clamp(eyeDistance * normal.x / facing, -kSteepest, kSteepest));
    map.slopeY[i] = static_cast<float>(std::clamp(eyeDistance * normal.y / facing, -kSteepest, kSteepest));
  }
  return map;
}

}  // namespace qrelief
