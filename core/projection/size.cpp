// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/size.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace qrelief {
namespace {

double maximumNorm(Vec2 p) { return std::max(std::abs(p.x), std::abs(p.y)); }

/// Returns the least maximum norm along a segment. The norm is convex, and linear between the axes and the diagonals,
/// so it is least at an end or where the segment crosses one of these four lines.
double leastMaximumNorm(const Segment2& segment) {
  const Vec2 a = segment[0];
  const Vec2 b = segment[1];
  double least = std::min(maximumNorm(a), maximumNorm(b));
  for (const Vec2 line : {Vec2(1, 0), Vec2(0, 1), Vec2(1, 1), Vec2(1, -1)}) {
    const double from = glm::dot(line, a);
    const double to = glm::dot(line, b);
    if ((from < 0) != (to < 0)) least = std::min(least, maximumNorm(a + (b - a) * (from / (from - to))));
  }
  return least;
}

}  // namespace

std::optional<Vec2> nearestSilhouettePoint(std::span<const Segment2> silhouette) {
  std::optional<Vec2> nearest;
  for (const Segment2& segment : silhouette) {
    const Vec2 point = nearestOnSegment(Vec2(0), segment);
    if (!nearest || glm::dot(point, point) < glm::dot(*nearest, *nearest)) nearest = point;
  }
  return nearest;
}

double freeSize(std::span<const Segment2> silhouette) {
  const std::optional<Vec2> nearest = nearestSilhouettePoint(silhouette);
  return nearest ? std::numbers::sqrt2 * glm::length(*nearest) : std::numeric_limits<double>::infinity();
}

double orientedSize(std::span<const Segment2> silhouette) {
  double half = std::numeric_limits<double>::infinity();
  for (const Segment2& segment : silhouette) half = std::min(half, leastMaximumNorm(segment));
  return 2 * half;
}

}  // namespace qrelief
