// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/two_values.h"

#include <array>
#include <utility>

namespace qrelief {
namespace {

/// A crossed triangle, with the corner first that is alone on its side.
Triangle aloneFirst(const Triangle& t, std::span<const float> sides) {
  const std::size_t k = sides[t[1]] == sides[t[2]] ? 0 : sides[t[0]] == sides[t[2]] ? 1 : 2;
  return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
}

}  // namespace

TwoValues twoValues(DisplayMesh display, std::span<const float> values, float threshold) {
  std::vector<float> sides;
  for (const float value : values) sides.push_back(value >= threshold ? 1.0f : 0.0f);
  Mesh& mesh = display.mesh;
  std::vector<Vec3f>& normals = display.normals;
  /// Adds the point of an edge that has the threshold; its two triangles find the same point.
  const auto crossing = [&](std::uint32_t a, std::uint32_t b, float side) {
    if (sides[a] > sides[b]) std::swap(a, b);
    const float share = (threshold - values[a]) / (values[b] - values[a]);
    const Vec3f normal = normals[a] + share * (normals[b] - normals[a]);
    const float length = glm::length(normal);
    mesh.positions.push_back(mesh.positions[a] + share * (mesh.positions[b] - mesh.positions[a]));
    normals.push_back(length > 0 ? normal / length : normal);
    sides.push_back(side);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh.triangles) {
    if (sides[t[0]] == sides[t[1]] && sides[t[1]] == sides[t[2]]) {
      triangles.push_back(t);
      continue;
    }
    const auto [alone, next, last] = aloneFirst(t, sides);
    const float own = sides[alone], other = sides[next];
    triangles.push_back({alone, crossing(alone, next, own), crossing(alone, last, own)});
    const std::uint32_t p = crossing(alone, next, other), q = crossing(alone, last, other);
    triangles.push_back({p, next, last});
    triangles.push_back({p, last, q});
  }
  mesh.triangles = std::move(triangles);
  mesh.bodyOf.clear();
  return {std::move(display), std::move(sides)};
}

}  // namespace qrelief
