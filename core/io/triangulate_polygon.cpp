// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/triangulate_polygon.h"

#include <cmath>

#include "math/tolerance.h"

namespace qrelief {
namespace {

/// Corner tests before ear clipping gives up, about a second: only hostile outlines get there.
constexpr std::size_t kMaxTests = 200'000'000;

Vec3 newellNormal(std::span<const Vec3> corners) {
  // About the first corner: far-away polygons would lose the area to cancellation.
  Vec3 sum(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return sum;
}

/// The polygon in its plane, counter-clockwise.
std::vector<Vec2> flattened(std::span<const Vec3> corners, Vec3 normal) {
  const Vec3 axis = std::abs(normal.x) <= std::abs(normal.y) && std::abs(normal.x) <= std::abs(normal.z) ? Vec3(1, 0, 0)
                    : std::abs(normal.y) <= std::abs(normal.z)                                           ? Vec3(0, 1, 0)
                                                               : Vec3(0, 0, 1);
  const Vec3 u = glm::normalize(glm::cross(axis, normal));
  const Vec3 v = glm::cross(normal, u);
  std::vector<Vec2> flat;
  flat.reserve(corners.size());
  for (const Vec3& p : corners) flat.emplace_back(glm::dot(p - corners[0], u), glm::dot(p - corners[0], v));
  return flat;
}

/// A left turn at b that is more than rounding.
bool turnsLeft(Vec2 a, Vec2 b, Vec2 c) {
  return cross2(b - a, c - b) > kStraightSine * glm::length(b - a) * glm::length(c - b);
}

/// Fan about corner `apex`, if all its triangles have area and the right sense. Such triangles cover a simple outline
/// once: a map of the disc that nowhere folds is one-to-one if it is on the boundary.
bool fanIsValid(std::span<const Vec2> flat, std::size_t apex) {
  const std::size_t n = flat.size();
  for (std::size_t i = 1; i + 1 < n; ++i)
    if (!turnsLeft(flat[apex], flat[(apex + i) % n], flat[(apex + i + 1) % n])) return false;
  return true;
}

void appendFan(std::span<const std::uint32_t> outline, std::size_t apex,
               std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const std::size_t n = outline.size();
  for (std::size_t i = 1; i + 1 < n; ++i)
    triangles.push_back({outline[apex], outline[(apex + i) % n], outline[(apex + i + 1) % n]});
}

/// Inside or on the border of the counter-clockwise triangle, its corners excepted.
bool blocks(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
  if (p == a || p == b || p == c) return false;
  return cross2(b - a, p - a) >= 0 && cross2(c - b, p - b) >= 0 && cross2(a - c, p - c) >= 0;
}

/// Ear clipping on a ring of corners.
class EarClipper {
 public:
  explicit EarClipper(std::span<const Vec2> flat) : flat_(flat), left_(flat.size()) {
    const auto n = static_cast<std::uint32_t>(flat.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      next_.push_back((i + 1) % n);
      previous_.push_back((i + n - 1) % n);
    }
    for (std::uint32_t i = 0; i < n; ++i)
      if (!turnsLeft(at(previous_[i]), at(i), at(next_[i]))) reflex_.push_back(i);
    clipped_.assign(n, false);
  }

  PolygonTriangles clipAll() {
    PolygonTriangles result;
    std::uint32_t corner = 0;
    std::size_t failures = 0;
    while (left_ > 3 && tests_ < kMaxTests) {
      const bool stuck = failures >= left_;
      if (stuck) result.simple = false;
      if (stuck || isEar(corner)) {
        corner = clip(corner, result);
        failures = 0;
      } else {
        corner = next_[corner];
        ++failures;
      }
    }
    std::vector<std::uint32_t> rest;
    for (std::size_t i = 0; i < left_; ++i, corner = next_[corner]) rest.push_back(corner);
    if (rest.size() > 3 || !turnsLeft(at(rest[0]), at(rest[1]), at(rest[2]))) result.simple = false;
    appendFan(rest, 0, result.triangles);
    return result;
  }

 private:
  Vec2 at(std::uint32_t i) const { return flat_[i]; }

  bool isEar(std::uint32_t i) {
    const Vec2 a = at(previous_[i]);
    const Vec2 b = at(i);
    const Vec2 c = at(next_[i]);
    if (!turnsLeft(a, b, c)) return false;
    tests_ += reflex_.size();
    for (const std::uint32_t r : reflex_)
      if (!clipped_[r] && blocks(at(r), a, b, c)) return false;
    return true;
  }

  /// Cuts the corner off and moves two on, so that the cuts are spread over the outline.
  std::uint32_t clip(std::uint32_t i, PolygonTriangles& result) {
    const std::uint32_t before = previous_[i];
    const std::uint32_t after = next_[i];
    result.triangles.push_back({before, i, after});
    next_[before] = after;
    previous_[after] = before;
    clipped_[i] = true;
    --left_;
    return next_[after];
  }

  std::span<const Vec2> flat_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<std::uint32_t> reflex_;  // a convex corner never becomes reflex, so this list only goes stale
  std::vector<bool> clipped_;
  std::size_t left_;
  std::size_t tests_ = 0;
};

}  // namespace

PolygonTriangles triangulatePolygon(std::span<const Vec3> corners) {
  std::vector<std::uint32_t> outline(corners.size());
  for (std::uint32_t i = 0; i < outline.size(); ++i) outline[i] = i;
  PolygonTriangles result;
  const Vec3 sum = newellNormal(corners);
  const double length = glm::length(sum);
  if (corners.size() == 3 || !(length > 0) || !std::isfinite(length)) {
    result.simple = length > 0;
    appendFan(outline, 0, result.triangles);
    return result;
  }
  const std::vector<Vec2> flat = flattened(corners, sum / length);
  const bool first = fanIsValid(flat, 0);
  const bool second = corners.size() == 4 && fanIsValid(flat, 1);
  if (first || second) {
    const bool secondIsShorter =
        second && glm::distance(corners[1], corners[3]) < glm::distance(corners[0], corners[2]);
    appendFan(outline, !first || secondIsShorter ? 1 : 0, result.triangles);
    return result;
  }
  return EarClipper(flat).clipAll();
}

}  // namespace qrelief
