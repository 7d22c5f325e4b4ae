// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace qrelief {
namespace {

constexpr std::size_t kTrianglesAPiece = 1 << 15;

std::array<double, 3> cornerAngles(const Mesh& mesh, std::size_t triangle) {
  std::array<double, 3> angles;
  for (int k = 0; k < 3; ++k) {
    const Vec3 p = mesh.corner(triangle, k);
    const Vec3 a = mesh.corner(triangle, (k + 1) % 3) - p;
    const Vec3 b = mesh.corner(triangle, (k + 2) % 3) - p;
    angles[k] = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  }
  return angles;
}

}  // namespace

Box3 boundingBox(const Mesh& mesh) {
  Box3 box;
  for (const Vec3f& p : mesh.positions) box.add(Vec3(p));
  return box;
}

double signedVolume(const Mesh& mesh) {
  // Tetrahedra start at the box's centre: from the origin, far-away models would lose the volume to cancellation.
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
  // The angles take most of the time and are independent of each other. The sums follow the triangles' order.
  std::vector<std::array<double, 3>> angles(mesh.triangles.size());
  parallelForPieces(angles.size(), kTrianglesAPiece, [&](std::size_t t) { angles[t] = cornerAngles(mesh, t); });
  std::vector<Vec3> sums(mesh.positions.size(), Vec3(0));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 normal = triangleNormal(mesh, t);
    for (std::size_t k = 0; k < 3; ++k) sums[mesh.triangles[t][k]] += normal * angles[t][k];
  }
  std::vector<Vec3f> normals(sums.size());
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double length = glm::length(sums[v]);
    normals[v] = length > 0 ? Vec3f(sums[v] / length) : Vec3f(0);
  }
  return normals;
}

}  // namespace qrelief
