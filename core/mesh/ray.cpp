// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ray.h"

#include <array>
#include <cmath>
#include <utility>

#include "math/tolerance.h"

namespace qrelief {
namespace {

/// The ray made the z axis by a shear: a triangle is hit where the origin lies in its projection [Woop, Benthin, Wald
/// 2013, Watertight ray/triangle intersection]. Each vertex is sheared once and each edge gives its two triangles the
/// same product with opposite signs, so no ray slips through between them.
class ShearedRay {
 public:
  ShearedRay(Vec3 origin, Vec3 direction) : origin_(origin) {
    const Vec3 size = glm::abs(direction);
    z_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    shear_ = {direction[x_] / direction[z_], direction[y_] / direction[z_], 1 / direction[z_]};
  }

  /// x, y across the ray; z in units of the direction's length.
  Vec3 apply(Vec3 p) const {
    const Vec3 q = p - origin_;
    return {q[x_] - shear_.x * q[z_], q[y_] - shear_.y * q[z_], shear_.z * q[z_]};
  }

 private:
  Vec3 origin_, shear_;
  int x_, y_, z_;
};

/// How far along the ray the triangle is hit, in units of the direction's length; negative if it is not.
double hitParameter(Vec3 a, Vec3 b, Vec3 c) {
  constexpr double kMiss = -1;
  const double u = c.x * b.y - c.y * b.x;
  const double v = a.x * c.y - a.y * c.x;
  const double w = b.x * a.y - b.y * a.x;
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return kMiss;
  const double sum = u + v + w;
  if (sum == 0) return kMiss;  // seen edge on: its neighbours are hit
  return (u * a.z + v * b.z + w * c.z) / sum;
}

/// [Ericson 2005, Real-Time Collision Detection, §5.1.5]
Vec3 closestOnTriangle(Vec3 a, Vec3 b, Vec3 c, Vec3 p) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = glm::dot(ab, p - a);
  const double d2 = glm::dot(ac, p - a);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = glm::dot(ab, p - b);
  const double d4 = glm::dot(ac, p - b);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
  const double d5 = glm::dot(ab, p - c);
  const double d6 = glm::dot(ac, p - c);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  const double sum = va + vb + vc;
  return a + ab * (vb / sum) + ac * (vc / sum);
}

/// Angle that a triangle takes up around a point of it: 2π within, π on a side, less at a corner.
double angleAround(Vec3 p, const std::array<Vec3, 3>& corners) {
  double angle = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 from = corners[k], to = corners[(k + 1) % 3];
    if (glm::distance(p, closestOnTriangle(from, to, to, p)) <= kOnSurfaceMm) continue;
    const Vec3 a = from - p, b = to - p;
    angle += std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  }
  return angle;
}

}  // namespace

std::optional<SurfacePoint> firstHit(const Mesh& mesh, Vec3 origin, Vec3 direction) {
  const ShearedRay ray(origin, direction);
  std::vector<Vec3> sheared;
  sheared.reserve(mesh.positions.size());
  for (const Vec3f& p : mesh.positions) sheared.push_back(ray.apply(Vec3(p)));
  std::optional<std::pair<double, std::uint32_t>> best;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double parameter = hitParameter(sheared[a], sheared[b], sheared[c]);
    if (parameter >= 0 && (!best || parameter < best->first)) best = {parameter, t};
  }
  if (!best) return std::nullopt;
  const auto [parameter, triangle] = *best;
  return SurfacePoint{origin + direction * parameter, triangle, parameter * glm::length(direction)};
}

std::optional<SurfacePoint> closestPoint(const Mesh& mesh, Vec3 query) {
  std::optional<SurfacePoint> best;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 p = closestOnTriangle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), query);
    const double distance = glm::distance(p, query);
    if (!best || distance < best->distance) best = SurfacePoint{p, t, distance};
  }
  return best;
}

Vec3 surfaceNormalAt(const Mesh& mesh, const SurfacePoint& point) {
  const Vec3 p = point.position;
  Vec3 sum(0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
    const Vec3 lo = glm::min(glm::min(a, b), c) - kOnSurfaceMm, hi = glm::max(glm::max(a, b), c) + kOnSurfaceMm;
    if (glm::any(glm::lessThan(p, lo)) || glm::any(glm::greaterThan(p, hi))) continue;
    if (glm::distance(p, closestOnTriangle(a, b, c, p)) > kOnSurfaceMm) continue;
    sum += triangleNormal(mesh, t) * angleAround(p, {a, b, c});
  }
  const Vec3 own = triangleNormal(mesh, point.triangle);
  return glm::dot(sum, own) > 0 ? glm::normalize(sum) : own;
}

}  // namespace qrelief
