// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh.h"

#include <cmath>

namespace qrelief {

Box3 boundingBox(const Mesh& mesh) {
  Box3 box;
  for (const Vec3f& p : mesh.positions) box.add(Vec3(p));
  return box;
}

double signedVolume(const Mesh& mesh) {
  // Tetrahedra from the box's centre: far-away models would lose the volume to cancellation.
  const Box3 box = boundingBox(mesh);
  if (box.empty()) return 0;
  const Vec3 origin = box.centre();
  double sixfold = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sixfold += glm::dot(mesh.corner(t, 0) - origin, glm::cross(mesh.corner(t, 1) - origin, mesh.corner(t, 2) - origin));
  return sixfold / 6;
}

Vec3 triangleNormal(const Mesh& mesh, std::size_t triangle) {
  const Vec3 a = mesh.corner(triangle, 0);
  const Vec3 n = glm::cross(mesh.corner(triangle, 1) - a, mesh.corner(triangle, 2) - a);
  const double length = glm::length(n);
  return length > 0 ? n / length : Vec3(0);
}

std::vector<Vec3f> vertexNormals(const Mesh& mesh) {
  std::vector<Vec3> sums(mesh.positions.size(), Vec3(0));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 normal = triangleNormal(mesh, t);
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = mesh.corner(t, k);
      const Vec3 a = mesh.corner(t, (k + 1) % 3) - p;
      const Vec3 b = mesh.corner(t, (k + 2) % 3) - p;
      const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
      sums[mesh.triangles[t][static_cast<std::size_t>(k)]] += normal * angle;
    }
  }
  std::vector<Vec3f> normals(sums.size());
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double length = glm::length(sums[v]);
    normals[v] = length > 0 ? Vec3f(sums[v] / length) : Vec3f(0);
  }
  return normals;
}

}  // namespace qrelief
