// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "mesh/self_intersection.h"
#include "mesh/sheared_ray.h"
#include "message_codes/place.h"

namespace qrelief {
namespace {

constexpr std::size_t kMaxPairs = 100'000;
constexpr double kOnPlaneFraction = 1e-9;  // of a triangle's sides: allowance for rounding

using Segment3 = std::array<Vec3, 2>;
using Corners = std::array<Vec3, 3>;

Corners cornersOf(const Mesh& mesh, std::uint32_t triangle) {
  return {mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)};
}

/// Collects the points where the sides of `a` pass through `b`.
void collectHits(const Corners& a, const Corners& b, std::vector<Vec3>& hits) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 from = a[k];
    const Vec3 along = a[(k + 1) % 3] - from;
    const ShearedRay ray(from, along);
    const double parameter = hitParameter(ray.apply(b[0]), ray.apply(b[1]), ray.apply(b[2]));
    if (parameter >= 0 && parameter <= 1) hits.push_back(from + along * parameter);
  }
}

/// Returns true if only a corner or a side of `b` lies in the plane of `a`, and the rest of it on one side.
bool touches(const Corners& a, const Corners& b) {
  const Vec3 u = a[1] - a[0], v = a[2] - a[0];
  const Vec3 normal = glm::normalize(glm::cross(u, v));
  const double tolerance = kOnPlaneFraction * std::max(glm::length(u), glm::length(v));
  bool above = false, below = false;
  for (const Vec3& corner : b) {
    const double height = glm::dot(normal, corner - a[0]);
    above = above || height > tolerance;
    below = below || height < -tolerance;
  }
  return above != below;
}

/// Returns true if `b` lies in the plane of `a`.
bool isCoplanar(const Corners& a, const Corners& b) {
  const Vec3 u = a[1] - a[0], v = a[2] - a[0];
  const Vec3 normal = glm::normalize(glm::cross(u, v));
  const double tolerance = kOnPlaneFraction * std::max(glm::length(u), glm::length(v));
  return std::all_of(b.begin(), b.end(),
                     [&](const Vec3& corner) { return std::abs(glm::dot(normal, corner - a[0])) <= tolerance; });
}

bool faceOppositeWays(const Corners& a, const Corners& b) {
  return glm::dot(glm::cross(a[1] - a[0], a[2] - a[0]), glm::cross(b[1] - b[0], b[2] - b[0])) < 0;
}

/// Returns the part of a segment that lies within a triangle in the same plane.
std::optional<Segment3> partWithin(const Segment3& segment, const Corners& triangle) {
  const Vec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  double from = 0, to = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 inward = glm::cross(normal, triangle[(k + 1) % 3] - triangle[k]);
    const double start = glm::dot(inward, segment[0] - triangle[k]), end = glm::dot(inward, segment[1] - triangle[k]);
    const double tolerance = kOnPlaneFraction * glm::length(inward) * std::sqrt(glm::length(normal));
    if (start < -tolerance && end < -tolerance) return std::nullopt;
    if (start < -tolerance) from = std::max(from, start / (start - end));
    if (end < -tolerance) to = std::min(to, start / (start - end));
  }
  if (from > to) return std::nullopt;
  const Vec3 along = segment[1] - segment[0];
  return Segment3{segment[0] + along * from, segment[0] + along * to};
}

/// Adds the parts of a triangle's sides that lie within another triangle of its plane.
void addSidesWithin(const Corners& other, const Corners& t, std::vector<Segment3>& segments) {
  for (std::size_t k = 0; k < 3; ++k)
    if (const auto part = partWithin({t[k], t[(k + 1) % 3]}, other)) segments.push_back(*part);
}

/// Adds the sides of a triangle.
void addSides(const Corners& t, std::vector<Segment3>& segments) {
  for (std::size_t k = 0; k < 3; ++k) segments.push_back({t[k], t[(k + 1) % 3]});
}

/// Returns the segment that two crossing triangles share, or the point where they touch. Triangles in one
/// plane share the sides of `b` that lie within `a`. If both face the same way, they also share the sides of `a` that
/// lie within `b`. If rounding hides the shared part, returns the sides of `a`.
std::vector<Segment3> commonSegments(const Corners& a, const Corners& b) {
  std::vector<Segment3> sides;
  if (isCoplanar(a, b)) {
    addSidesWithin(a, b, sides);
    if (!faceOppositeWays(a, b)) addSidesWithin(b, a, sides);
    if (!sides.empty()) return sides;
    addSides(a, sides);
    return sides;
  }
  std::vector<Vec3> hits;
  collectHits(a, b, hits);
  collectHits(b, a, hits);
  Segment3 longest{};
  double length = 0;
  for (const Vec3& p : hits)
    for (const Vec3& q : hits)
      if (glm::distance(p, q) > length) {
        length = glm::distance(p, q);
        longest = {p, q};
      }
  if (length > 0) return {longest};
  if (!hits.empty() && (touches(a, b) || touches(b, a))) return {{hits.front(), hits.front()}};
  addSides(a, sides);
  return sides;
}

/// Finds the segments that facets of the patch share with others, some of which may also belong to the patch.
/// @param known  see addCrossings()
Result<std::vector<Segment3>> crossingsOf(const Mesh& mesh, std::span<const std::uint32_t> triangles,
                                          const std::vector<TrianglePair>* known) {
  std::vector<TrianglePair> found;
  if (!known) {
    auto pairs = findCrossings(mesh, triangles, kMaxPairs);
    QRELIEF_TRY(pairs);
    if (pairs->size() >= kMaxPairs)
      return fail(ErrorKind::NoSolution, message<"too-many-crossings">(with::count<"most">(kMaxPairs)));
    found = std::move(*pairs);
  }
  std::vector<Segment3> segments;
  for (const auto& [s, t] : known ? *known : found) {
    for (const auto& [mine, other] : {std::array{s, t}, std::array{t, s}}) {
      if (!std::binary_search(triangles.begin(), triangles.end(), mine)) continue;
      for (const Segment3& segment : commonSegments(cornersOf(mesh, mine), cornersOf(mesh, other)))
        segments.push_back(segment);
    }
  }
  return segments;
}

Vec3 nearestOn(const Segment3& segment, Vec3 place) {
  const Vec3 along = segment[1] - segment[0];
  const double squared = glm::dot(along, along);
  const double parameter = squared > 0 ? glm::dot(place - segment[0], along) / squared : 0;
  return segment[0] + std::clamp(parameter, 0.0, 1.0) * along;
}

}  // namespace

Status addCrossings(const Mesh& mesh, const ProjectionFrame& frame, VisiblePatch& patch,
                    const std::vector<TrianglePair>* known) {
  const auto segments = crossingsOf(mesh, patch.triangles, known);
  QRELIEF_TRY(segments);
  for (const auto& [from, to] : *segments) patch.silhouette.push_back({frame.project(from), frame.project(to)});
  return {};
}

Result<std::optional<Vec3>> nearestCrossing(const Mesh& mesh, std::span<const std::uint32_t> triangles, Vec3 place,
                                            const std::vector<TrianglePair>* known) {
  const auto segments = crossingsOf(mesh, triangles, known);
  QRELIEF_TRY(segments);
  std::optional<Vec3> nearest;
  for (const Segment3& segment : *segments) {
    const Vec3 point = nearestOn(segment, place);
    if (!nearest || glm::distance(point, place) < glm::distance(*nearest, place)) nearest = point;
  }
  return nearest;
}

}  // namespace qrelief
