// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/crossing_segments.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/triangle_separation.h"

namespace qrelief {
namespace {

constexpr double kOnPlaneFraction = 1e-9;  // of a triangle's sides: allowance for rounding

Corners cornersOf(const Mesh& mesh, std::uint32_t triangle) {
  return {mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)};
}

Vec3 areaNormal(const Corners& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

/// Returns true if `b` lies in the plane of `a`.
bool isCoplanar(const Corners& a, const Corners& b) {
  const Vec3 normal = areaNormal(a);
  const double side = std::max(glm::distance(a[0], a[1]), glm::distance(a[0], a[2]));
  const double tolerance = kOnPlaneFraction * side * glm::length(normal);
  return std::all_of(b.begin(), b.end(),
                     [&](const Vec3& corner) { return std::abs(glm::dot(normal, corner - a[0])) <= tolerance; });
}

/// Returns the part of a segment that lies within a triangle in the same plane.
std::optional<Segment3> partWithin(const Segment3& segment, const Corners& triangle) {
  const Vec3 normal = areaNormal(triangle);
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

/// Returns the segments that triangles in one plane share. If rounding hides them, returns the sides of `a`.
std::vector<Segment3> sidesInCommon(const Corners& a, const Corners& b) {
  std::vector<Segment3> sides;
  addSidesWithin(a, b, sides);
  const bool faceOppositeWays = glm::dot(areaNormal(a), areaNormal(b)) < 0;
  if (!faceOppositeWays || sides.empty()) addSidesWithin(b, a, sides);  // empty: `b` covers `a`
  if (sides.empty()) sides = {{a[0], a[1]}, {a[1], a[2]}, {a[2], a[0]}};
  return sides;
}

/// Returns the section of a triangle with a plane that it meets, from its first to its last point along a direction. If
/// rounding hides the section, it is the corner nearest to the plane.
Segment3 sectionOf(const Corners& t, const Corners& plane, Vec3 direction) {
  const Vec3 normal = areaNormal(plane);
  std::array<double, 3> heights;
  std::transform(t.begin(), t.end(), heights.begin(), [&](Vec3 corner) { return glm::dot(normal, corner - plane[0]); });
  std::vector<Vec3> met;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (heights[k] == 0) met.push_back(t[k]);
    if (std::min(heights[k], heights[next]) < 0 && std::max(heights[k], heights[next]) > 0)
      met.push_back(t[k] + (t[next] - t[k]) * (heights[k] / (heights[k] - heights[next])));
  }
  if (met.empty()) {
    const auto nearest =
        std::min_element(heights.begin(), heights.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    met.push_back(t[static_cast<std::size_t>(nearest - heights.begin())]);
  }
  const auto [first, last] =
      std::minmax_element(met.begin(), met.end(), [&](Vec3 a, Vec3 b) { return glm::dot(direction, a - b) < 0; });
  return {*first, *last};
}

}  // namespace

std::vector<Segment3> crossingSegments(const Mesh& mesh, std::uint32_t first, std::uint32_t second) {
  const Corners a = cornersOf(mesh, first), b = cornersOf(mesh, second);
  if (isCoplanar(a, b)) return sidesInCommon(a, b);
  const Vec3 line = glm::cross(areaNormal(a), areaNormal(b));
  const Segment3 ofA = sectionOf(a, b, line), ofB = sectionOf(b, a, line);
  const auto isBefore = [&](Vec3 p, Vec3 q) { return glm::dot(line, p - q) < 0; };
  // Of triangles that meet in a point, rounding may exchange the ends: they are as near as rounding errors.
  return {{isBefore(ofA[0], ofB[0]) ? ofB[0] : ofA[0], isBefore(ofA[1], ofB[1]) ? ofA[1] : ofB[1]}};
}

Vec3 crossingPoint(const Mesh& mesh, const TrianglePair& pair) {
  const std::vector<Segment3> segments = crossingSegments(mesh, pair[0], pair[1]);
  const auto longest = std::max_element(segments.begin(), segments.end(), [](const Segment3& s, const Segment3& t) {
    return glm::distance(s[0], s[1]) < glm::distance(t[0], t[1]);
  });
  return ((*longest)[0] + (*longest)[1]) / 2.0;
}

}  // namespace qrelief
