// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/cross_sections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace qrelief {
namespace {

Vec2 flat(Vec3 p) { return {p.x, p.y}; }

/// Returns the point where an edge meets a plane; it is the same in both directions of the edge.
Vec2 crossing(Vec3 a, Vec3 b, double height) {
  if (b.z < a.z) std::swap(a, b);
  return flat(a) + (flat(b) - flat(a)) * ((height - a.z) / (b.z - a.z));
}

Segment2 cut(const std::array<Vec3, 3>& corners, double height) {
  int above = 0;
  for (const Vec3& corner : corners) above += corner.z >= height;
  // The corner that is alone on its side. If it is above, the solid lies left of the line from the edge after it to the
  // edge before it; otherwise the other way round.
  std::size_t alone = 0;
  while ((corners[alone].z >= height) != (above == 1)) ++alone;
  const Vec3 &apex = corners[alone], &next = corners[(alone + 1) % 3], &last = corners[(alone + 2) % 3];
  const Vec2 p = crossing(apex, next, height), q = crossing(apex, last, height);
  return above == 1 ? Segment2{p, q} : Segment2{q, p};
}

/// Intersection of a vertical line with a triangle, and the change of the winding number there.
struct Piercing {
  double height = 0;
  int change = 0;  ///< change of the winding number, going up
};

std::optional<Piercing> pierce(const std::array<Vec3, 3>& corners, Vec2 at) {
  std::array<double, 3> weights{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 a = flat(corners[(k + 1) % 3]) - at, b = flat(corners[(k + 2) % 3]) - at;
    weights[k] = cross2(a, b);
  }
  const double area = weights[0] + weights[1] + weights[2];
  if (area == 0) return std::nullopt;
  for (const double weight : weights)
    if (area > 0 ? weight < 0 : weight >= 0) return std::nullopt;
  double height = 0;
  for (std::size_t k = 0; k < 3; ++k) height += weights[k] / area * corners[k].z;
  return Piercing{height, area > 0 ? -1 : 1};
}

}  // namespace

int CuttingPlanes::firstAbove(double z) const {
  const double about = std::floor((z - firstMm) / stepMm);
  int plane = static_cast<int>(std::clamp(about, 0.0, static_cast<double>(count)));
  while (plane > 0 && heightMm(plane - 1) > z) --plane;
  while (plane < count && heightMm(plane) <= z) ++plane;
  return plane;
}

CrossSections cutByPlanes(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                          const CuttingPlanes& planes, Vec2 low, Vec2 high) {
  CrossSections sections;
  sections.outlines.resize(static_cast<std::size_t>(planes.count));
  sections.windings.assign(static_cast<std::size_t>(planes.count), 0);
  for (const auto& [a, b, c] : triangles) {
    const std::array<Vec3, 3> corners{positions[a], positions[b], positions[c]};
    const Vec3 least = glm::min(glm::min(corners[0], corners[1]), corners[2]);
    const Vec3 most = glm::max(glm::max(corners[0], corners[1]), corners[2]);
    if (most.x < low.x || most.y < low.y || least.x > high.x || least.y > high.y) continue;
    if (const auto piercing = pierce(corners, low)) {
      // The winding numbers of all planes above it change by as much.
      const double beyond = std::ceil((piercing->height - planes.firstMm) / planes.stepMm);
      for (int k = static_cast<int>(std::clamp(beyond, 0.0, static_cast<double>(planes.count))); k < planes.count; ++k)
        sections.windings[k] += piercing->change;
    }
    const int end = planes.firstAbove(most.z);
    for (int k = planes.firstAbove(least.z); k < end; ++k)
      sections.outlines[k].push_back(cut(corners, planes.heightMm(k)));
  }
  return sections;
}

}  // namespace qrelief
