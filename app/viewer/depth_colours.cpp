// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/depth_colours.h"

#include <algorithm>
#include <cmath>

#include "pipeline/engrave.h"

namespace qrelief {
namespace {

constexpr double kTopStepMm = 0.1;
constexpr double kWallCosine = 0.02;  // a facet seen from the eye at less is a wall, which runs along the eye's rays

/// Returns the depth of the submodule under a point of the QR plane; 0 outside the symbol.
double depthAt(const DepthField& depths, Vec2 onPlane) {
  const int column = static_cast<int>(std::floor((onPlane.x + depths.symbolMm / 2) / depths.submoduleMm()));
  const int row = static_cast<int>(std::floor((depths.symbolMm / 2 - onPlane.y) / depths.submoduleMm()));
  if (column < 0 || row < 0 || column >= depths.size || row >= depths.size) return 0;
  return depths.depth(row, column);
}

/// Returns the depth of a new facet other than a wall. @param middle  its centroid
double depthOf(const EngraveResult& result, std::size_t triangle, Vec3 middle) {
  if (!result.request.code.isText()) return depthAt(result.depths, result.placement.frame.project(middle));
  return result.origins[triangle].kind == FacetOrigin::Kind::Floor ? result.label.depthMm : 0;
}

}  // namespace

double depthColoursTopMm(const EngraveResult& result) {
  return std::max(kTopStepMm, std::ceil(pocketDepths(result).p95Mm / kTopStepMm - 1e-6) * kTopStepMm);
}

std::vector<float> depthColours(const EngraveResult& result, const DisplayMesh& display) {
  const ProjectionFrame& frame = result.placement.frame;
  const Mesh& mesh = result.mesh;
  const double topMm = depthColoursTopMm(result);
  std::vector<float> values(display.mesh.positions.size(), 0);
  struct Floor {
    std::size_t triangle;
    float value;
  };
  std::vector<Floor> floors;
  std::vector<std::size_t> walls, others;
  std::vector<float> ofFloors(mesh.positions.size(), 0);  // per vertex of the mesh: depth of the floors there, for
                                                          // walls
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    const bool isKept = t < result.keptTriangles;
    if (!isKept && std::abs(glm::dot(triangleNormal(mesh, t), glm::normalize(frame.eye() - middle))) < kWallCosine) {
      walls.push_back(t);
      continue;
    }
    const auto value = isKept ? 0.0f : static_cast<float>(std::min(1.0, depthOf(result, t, middle) / topMm));
    if (value == 0) {
      others.push_back(t);
      continue;
    }
    floors.push_back({t, value});
    for (const std::uint32_t v : mesh.triangles[t]) ofFloors[v] = std::max(ofFloors[v], value);
  }
  // The display mesh may share a vertex between a wall and the surface, or between a wall and a floor: the surface
  // wins, then the floor.
  for (const std::size_t t : walls)
    for (std::size_t k = 0; k < 3; ++k) values[display.mesh.triangles[t][k]] = ofFloors[mesh.triangles[t][k]];
  std::vector<bool> isSurface(values.size(), false);
  for (const std::size_t t : others)
    for (const std::uint32_t v : display.mesh.triangles[t]) isSurface[v] = true;
  for (std::size_t v = 0; v < values.size(); ++v)
    if (isSurface[v]) values[v] = 0;
  for (const Floor& floor : floors) {
    const Triangle& triangle = display.mesh.triangles[floor.triangle];
    // A crease separates floors from the surface. Without one, it is a sliver of the surface, as outlines move a
    // little.
    if (isSurface[triangle[0]] || isSurface[triangle[1]] || isSurface[triangle[2]]) continue;
    for (const std::uint32_t v : triangle) values[v] = std::max(values[v], floor.value);
  }
  return values;
}

}  // namespace qrelief
