// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/display_mesh.h"

#include <algorithm>
#include <cmath>

#include "math/angle.h"

namespace qrelief {
namespace {

// Corners of one vertex: `corner` = 3·triangle + k.
struct CornersOfVertices {
  std::vector<std::uint32_t> first;  // per vertex, one more at the end
  std::vector<std::uint32_t> corners;
};

CornersOfVertices collectCorners(const Mesh& mesh) {
  CornersOfVertices result;
  result.first.assign(mesh.positions.size() + 1, 0);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) ++result.first[v + 1];
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) result.first[v + 1] += result.first[v];
  result.corners.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) result.corners[next[mesh.triangles[t][k]]++] = 3 * t + k;
  return result;
}

// With more facets around a vertex (the tip of a fan), each keeps its own normal: comparing each with all others would
// take quadratic time.
constexpr std::uint32_t kMostCompared = 256;

float cornerAngle(const Mesh& mesh, std::uint32_t corner) {
  const Triangle& t = mesh.triangles[corner / 3];
  const Vec3f at = mesh.positions[t[corner % 3]];
  const std::uint32_t k = corner % 3;
  const Vec3f a = mesh.positions[t[(k + 1) % 3]] - at;
  const Vec3f b = mesh.positions[t[(k + 2) % 3]] - at;
  const float lengths = glm::length(a) * glm::length(b);
  return lengths > 0 ? std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0f, 1.0f)) : 0.0f;
}

}  // namespace

DisplayMesh splitAtCreases(const Mesh& mesh, double creaseDeg) {
  const auto limit = static_cast<float>(std::cos(toRadians(creaseDeg)));
  const CornersOfVertices around = collectCorners(mesh);
  std::vector<Vec3f> facets(mesh.triangles.size());
  for (std::size_t t = 0; t < facets.size(); ++t) facets[t] = Vec3f(triangleNormal(mesh, t));

  DisplayMesh display;
  display.mesh.triangles = mesh.triangles;
  display.mesh.positions.reserve(mesh.positions.size());
  display.normals.reserve(mesh.positions.size());
  std::vector<Vec3f> weighted;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const auto begin = around.first[v], end = around.first[v + 1];
    const bool isHub = end - begin > kMostCompared;
    weighted.clear();
    for (auto i = begin; i < end && !isHub; ++i)
      weighted.push_back(facets[around.corners[i] / 3] * cornerAngle(mesh, around.corners[i]));
    const auto firstCopy = static_cast<std::uint32_t>(display.normals.size());
    for (auto i = begin; i < end; ++i) {
      const Vec3f own = facets[around.corners[i] / 3];
      Vec3f sum(0);
      for (auto j = begin; j < end && !isHub; ++j)
        if (glm::dot(own, facets[around.corners[j] / 3]) >= limit) sum += weighted[j - begin];
      const float length = glm::length(sum);
      const Vec3f normal = length > 0 ? sum / length : own;
      // Corners that average over the same facets add them in the same order, so their normals are equal to the last
      // bit.
      auto copy = isHub ? static_cast<std::uint32_t>(display.normals.size()) : firstCopy;
      while (copy < display.normals.size() && display.normals[copy] != normal) ++copy;
      if (copy == display.normals.size()) {
        display.mesh.positions.push_back(mesh.positions[v]);
        display.normals.push_back(normal);
      }
      display.mesh.triangles[around.corners[i] / 3][around.corners[i] % 3] = copy;
    }
  }
  return display;
}

void takeSmoothNormals(DisplayMesh& carved, std::size_t firstTriangle, const ProjectionFrame& frame,
                       const MapWindow& window, std::span<const float> smooth, double creaseDeg) {
  const double limit = std::cos(toRadians(creaseDeg));
  for (std::size_t t = firstTriangle; t < carved.mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : carved.mesh.triangles[t]) {
      const Vec2 at = (frame.project(Vec3(carved.mesh.positions[v])) + window.extentMm / 2) / window.texelMm();
      if (!(at.x >= 0 && at.y >= 0 && at.x < window.texels && at.y < window.texels)) continue;
      const auto texel = 4 * static_cast<std::size_t>(static_cast<int>(at.y) * window.texels + static_cast<int>(at.x));
      const Vec3 normal = frame.right * static_cast<double>(smooth[texel]) +
                          frame.up * static_cast<double>(smooth[texel + 1]) +
                          frame.normal * static_cast<double>(smooth[texel + 2]);
      if (glm::dot(normal, Vec3(carved.normals[v])) >= limit) carved.normals[v] = Vec3f(normal);
    }
  }
}

}  // namespace qrelief
