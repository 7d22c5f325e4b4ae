// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_separation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace qrelief {
namespace {

// Bounds of rounding errors, with u = 2^-53 ≈ 1.1e-16, doubled for directed rounding. m is the largest coordinate of
// the differences of corners; each difference has a relative error of u.
constexpr double kDotError = 1e-15;       // of a dot product with differences, in |axis|₁·m: at most 4u
constexpr double kCrossDotError = 1e-13;  // of (d × e)·(d × f), in m⁴: at most 12 products, 11u each

double sumOf(Vec3 v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// The corners relative to one nearby corner. The differences are as exact as the corners, but small.
struct Differences {
  std::array<Vec3, 3> a, b;
  double largest = 0;

  Differences(const Corners& cornersA, const Corners& cornersB) {
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = cornersA[k] - cornersA[0];
      b[k] = cornersB[k] - cornersA[0];
      largest = std::max({largest, largestOf(a[k]), largestOf(b[k])});
    }
  }
};

/// Returns true if a plane across `axis` separates the triangles.
bool parts(const Differences& d, Vec3 axis) {
  const std::array<double, 3> a{glm::dot(axis, d.a[0]), glm::dot(axis, d.a[1]), glm::dot(axis, d.a[2])};
  const std::array<double, 3> b{glm::dot(axis, d.b[0]), glm::dot(axis, d.b[1]), glm::dot(axis, d.b[2])};
  const double gap = 2 * kDotError * sumOf(axis) * d.largest;
  return std::min({a[0], a[1], a[2]}) - std::max({b[0], b[1], b[2]}) > gap ||
         std::min({b[0], b[1], b[2]}) - std::max({a[0], a[1], a[2]}) > gap;
}

/// Returns true if p and q certainly lie on one side of the plane through 0, u and v, and not in it.
bool onOneSide(Vec3 u, Vec3 v, Vec3 p, Vec3 q, double largest) {
  const Vec3 normal = glm::cross(u, v);
  const double error = kVolumeError * largest * largest * largest;
  const double heightOfP = glm::dot(normal, p);
  const double heightOfQ = glm::dot(normal, q);
  return (heightOfP > error && heightOfQ > error) || (heightOfP < -error && heightOfQ < -error);
}

}  // namespace

double largestOf(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

bool certainlySeparate(const Corners& a, const Corners& b) {
  const Differences d(a, b);
  // Neighbours in a smooth surface lie side by side rather than one above the other.
  if (parts(d, d.b[0] + d.b[1] + d.b[2] - d.a[1] - d.a[2])) return true;
  const Vec3 normalA = glm::cross(d.a[1], d.a[2]);
  if (parts(d, normalA)) return true;
  const Vec3 normalB = glm::cross(d.b[1] - d.b[0], d.b[2] - d.b[0]);
  if (parts(d, normalB)) return true;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (parts(d, glm::cross(normalA, d.a[next] - d.a[k])) || parts(d, glm::cross(normalB, d.b[next] - d.b[k])))
      return true;
  }
  return false;
}

bool certainlySeparateButForCorner(const Corners& a, const Corners& b) {
  const Differences d(a, b);
  // A plane across the difference of the middle directions separates the two wedges if they are narrow.
  const auto middle = [](Vec3 u, Vec3 v) { return u * glm::length(v) + v * glm::length(u); };
  const Vec3 middleA = middle(d.a[1], d.a[2]);
  const Vec3 middleB = middle(d.b[1], d.b[2]);
  const Vec3 axis = middleA * glm::length(middleB) - middleB * glm::length(middleA);
  const double error = kDotError * sumOf(axis) * d.largest;
  if (glm::dot(axis, d.a[1]) > error && glm::dot(axis, d.a[2]) > error && glm::dot(axis, d.b[1]) < -error &&
      glm::dot(axis, d.b[2]) < -error)
    return true;
  return onOneSide(d.a[1], d.a[2], d.b[1], d.b[2], d.largest) || onOneSide(d.b[1], d.b[2], d.a[1], d.a[2], d.largest);
}

bool certainlySeparateButForEdge(const Corners& a, const Corners& b) {
  const Differences d(a, b);
  const Vec3 edge = d.a[1];
  // Either the apexes lie on different sides of the edge, or not in one plane with it.
  const double m = d.largest;
  const Vec3 towardsA = glm::cross(edge, d.a[2]);
  if (glm::dot(towardsA, glm::cross(edge, d.b[2])) < -kCrossDotError * m * m * m * m) return true;
  return std::abs(glm::dot(towardsA, d.b[2])) > kVolumeError * m * m * m;
}

}  // namespace qrelief
