// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ray.h"

#include <utility>

#include "math/tolerance.h"
#include "mesh/sheared_ray.h"

namespace qrelief {
namespace {

/// Returns the point of a triangle nearest to p [Ericson 2005, Real-Time Collision Detection, §5.1.5].
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

/// Returns the angle that a triangle takes up around one of its points: 2π within, π on a side, less at a corner.
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
