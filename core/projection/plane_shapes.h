// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "math/vec.h"

// Segments and triangles of the QR plane and their distances: for measuring, not for deciding topology.

namespace qrelief {

using Segment2 = std::array<Vec2, 2>;   ///< in plane coordinates, mm
using Triangle2 = std::array<Vec2, 3>;  ///< the same; a triangle whose last two corners coincide is a segment

inline Vec2 nearestOnSegment(Vec2 point, const Segment2& segment) {
  const Vec2 along = segment[1] - segment[0];
  const double squared = glm::dot(along, along);
  const double fraction = squared > 0 ? std::clamp(glm::dot(point - segment[0], along) / squared, 0.0, 1.0) : 0;
  return segment[0] + along * fraction;
}

inline double distanceToSegment(Vec2 point, const Segment2& segment) {
  return glm::distance(point, nearestOnSegment(point, segment));
}

/// Returns 0 inside. @param triangle  counter-clockwise
inline double distanceToTriangle(Vec2 point, const Triangle2& triangle) {
  bool inside = true;
  double distance = glm::distance(point, triangle[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Segment2 side{triangle[k], triangle[(k + 1) % 3]};
    inside = inside && cross2(side[1] - side[0], point - side[0]) >= 0;
    distance = std::min(distance, distanceToSegment(point, side));
  }
  return inside ? 0 : distance;
}

/// Returns 0 if the segments cross.
inline double distanceBetween(const Segment2& s, const Segment2& t) {
  const auto parts = [](const Segment2& line, Vec2 p, Vec2 q) {
    const Vec2 along = line[1] - line[0];
    return (cross2(along, p - line[0]) < 0) != (cross2(along, q - line[0]) < 0);
  };
  if (parts(s, t[0], t[1]) && parts(t, s[0], s[1])) return 0;
  return std::min(
      {distanceToSegment(s[0], t), distanceToSegment(s[1], t), distanceToSegment(t[0], s), distanceToSegment(t[1], s)});
}

}  // namespace qrelief
