// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flat_region.h"

#include <cmath>

#include "math/angle.h"

namespace qrelief {
namespace {

Vec3 areaVector(const Mesh& mesh, std::uint32_t triangle) {
  const Vec3 at = mesh.corner(triangle, 0);
  return glm::cross(mesh.corner(triangle, 1) - at, mesh.corner(triangle, 2) - at);
}

}  // namespace

Vec3 flatRegionNormal(const Mesh& mesh, const Adjacency& adjacency, std::uint32_t triangle, double toleranceDeg) {
  const Vec3 own = triangleNormal(mesh, triangle);
  const double least = std::cos(toRadians(toleranceDeg));
  std::vector<bool> isFound(mesh.triangles.size(), false);
  std::vector<std::uint32_t> found = {triangle};
  isFound[triangle] = true;
  Vec3 sum(0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    sum += areaVector(mesh, found[i]);
    for (const std::uint32_t next : adjacency[found[i]]) {
      if (next == kNoTriangle || isFound[next] || glm::dot(triangleNormal(mesh, next), own) < least) continue;
      isFound[next] = true;
      found.push_back(next);
    }
  }
  return glm::normalize(sum);
}

}  // namespace qrelief
