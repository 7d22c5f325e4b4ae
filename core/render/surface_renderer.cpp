// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface_renderer.h"

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

}  // namespace qrelief
