// SPDX-License-Identifier: GPL-3.0-or-later
#include "wasm/depth_colours.h"

#include <algorithm>
#include <cmath>

namespace qrelief {
namespace {

constexpr double kTopStepMm = 0.1;
constexpr double kWallCosine = 0.02;  // facets seen from the eye at less are walls: they run along its rays

/// Depth of the submodule under a point of the QR plane; 0 outside the symbol.
double depthAt(const DepthField& depths, Vec2 onPlane) {
  const int column = static_cast<int>(std::floor((onPlane.x + depths.symbolMm / 2) / depths.submoduleMm()));
  const int row = static_cast<int>(std::floor((depths.symbolMm / 2 - onPlane.y) / depths.submoduleMm()));
  if (column < 0 || row < 0 || column >= depths.size || row >= depths.size) return 0;
  return depths.depth(row, column);
}

}  // namespace

DepthColours depthColours(const EngraveResult& result, const DisplayMesh& display) {
  const ProjectionFrame& frame = result.placement.frame;
  const Mesh& mesh = result.mesh;
  DepthColours colours;
  colours.topMm = std::max(kTopStepMm, std::ceil(summarise(result.depths).maxMm / kTopStepMm - 1e-6) * kTopStepMm);
  colours.values.assign(display.mesh.positions.size(), 0);
  // Per vertex of the mesh, where a floor meets it: what a wall takes there.
  std::vector<float> ofFloors(mesh.positions.size(), 0);
  std::vector<std::size_t> walls;
  for (std::size_t t = result.keptTriangles; t < mesh.triangles.size(); ++t) {
    const Vec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    if (std::abs(glm::dot(triangleNormal(mesh, t), glm::normalize(frame.eye() - middle))) < kWallCosine) {
      walls.push_back(t);
      continue;
    }
    const auto value = static_cast<float>(depthAt(result.depths, frame.project(middle)) / colours.topMm);
    for (std::size_t k = 0; k < 3; ++k) {
      float& shown = colours.values[display.mesh.triangles[t][k]];
      float& floor = ofFloors[mesh.triangles[t][k]];
      shown = std::max(shown, value);
      floor = std::max(floor, value);
    }
  }
  for (const std::size_t t : walls)
    for (std::size_t k = 0; k < 3; ++k) colours.values[display.mesh.triangles[t][k]] = ofFloors[mesh.triangles[t][k]];
  return colours;
}

}  // namespace qrelief
