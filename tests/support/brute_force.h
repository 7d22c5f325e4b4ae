// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

#include "math/frame.h"
#include "mesh/topology.h"

/// Slow and simple references that faster code is compared with.
namespace qrelief::brute_force {

struct Hit {
  std::uint32_t triangle = kNoTriangle;
  double distance = std::numeric_limits<double>::infinity();
};

/// Finds the first facet that a ray meets by testing all triangles in turn.
/// @param direction  unit
inline Hit castRay(const Mesh& mesh, Vec3 origin, Vec3 direction) {
  constexpr double kSlack = 1e-12;  // an edge belongs to both its triangles
  Hit first;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 a = mesh.corner(t, 0);
    const Vec3 ab = mesh.corner(t, 1) - a;
    const Vec3 ac = mesh.corner(t, 2) - a;
    const double volume = glm::dot(ab, glm::cross(direction, ac));
    if (volume == 0) continue;
    const double u = glm::dot(origin - a, glm::cross(direction, ac)) / volume;
    const double v = glm::dot(direction, glm::cross(origin - a, ab)) / volume;
    if (u < -kSlack || v < -kSlack || u + v > 1 + kSlack) continue;
    const double distance = glm::dot(ac, glm::cross(origin - a, ab)) / volume;
    if (distance > 0 && distance < first.distance) first = {t, distance};
  }
  return first;
}

/// Frame at the point where a ray meets the mesh, and the facet there.
struct Spot {
  ProjectionFrame frame;
  std::uint32_t seed = kNoTriangle;
};

/// Casts a ray from `from` along `direction` to find the centre; `normal` becomes the frame's normal.
inline Spot spotSeen(const Mesh& mesh, Vec3 from, Vec3 direction, Vec3 normal, Vec3 up, double eyeDistance = 250) {
  const Vec3 unit = glm::normalize(direction);
  const Hit hit = castRay(mesh, from, unit);
  return {makeFrame(from + unit * hit.distance, normal, up, eyeDistance), hit.triangle};
}

/// Returns a point's distance from a facet: from its inside, its sides or its corners, whichever is nearest.
inline double distanceToFacet(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const auto toSegment = [p](Vec3 from, Vec3 to) {
    const Vec3 along = to - from;
    const double share = glm::dot(p - from, along) / glm::dot(along, along);
    return glm::distance(p, from + along * std::fmin(1, std::fmax(0, share)));
  };
  const Vec3 normal = glm::normalize(glm::cross(b - a, c - a));
  const double height = glm::dot(p - a, normal);
  const Vec3 foot = p - normal * height;
  const bool inside = glm::dot(glm::cross(b - a, foot - a), normal) >= 0 &&
                      glm::dot(glm::cross(c - b, foot - b), normal) >= 0 &&
                      glm::dot(glm::cross(a - c, foot - c), normal) >= 0;
  return inside ? std::abs(height) : std::fmin(toSegment(a, b), std::fmin(toSegment(b, c), toSegment(c, a)));
}

}  // namespace qrelief::brute_force
