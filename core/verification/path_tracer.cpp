// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/path_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/halton.h"
#include "base/random.h"

namespace qrelief {
namespace {

constexpr double kLeaveSurfaceMm = 1e-6;  // along the new direction, so that a path does not hit where it starts
constexpr int kSureBounces = 3;

/// Cosine-weighted about the normal [Malley's method; axes: Duff et al. 2017].
Vec3 cosineDirection(Vec3 normal, double u, double v) {
  const double sign = std::copysign(1.0, normal.z);
  const double a = -1 / (sign + normal.z);
  const double b = normal.x * normal.y * a;
  const Vec3 x{1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
  const Vec3 y{b, sign + normal.y * normal.y * a, -normal.y};
  const double radius = std::sqrt(u), angle = 2 * std::numbers::pi * v;
  return x * (radius * std::cos(angle)) + y * (radius * std::sin(angle)) + normal * std::sqrt(std::max(0.0, 1 - u));
}

/// Facet normal on the side that the ray comes from.
Vec3 facing(const Mesh& mesh, const SurfacePoint& at, Vec3 direction) {
  const Vec3 normal = triangleNormal(mesh, at.triangle);
  return glm::dot(normal, direction) > 0 ? -normal : normal;
}

struct Path {
  bool seesSky = false;
  double luminance = 0;
};

Path trace(const RayTree& tree, SurfacePoint at, Vec3 from, std::array<double, 2> first, double albedo,
           Random& random) {
  double throughput = 1;
  for (int bounce = 0;; ++bounce) {
    const Vec3 normal = facing(tree.mesh(), at, from);
    const double u = bounce == 0 ? first[0] : random.uniform();
    const double v = bounce == 0 ? first[1] : random.uniform();
    const Vec3 direction = cosineDirection(normal, u, v);
    const auto hit = tree.firstHit(at.position, direction, kLeaveSurfaceMm);
    if (!hit) return {bounce == 0, throughput};
    if (bounce < kSureBounces)
      throughput *= albedo;
    else if (random.uniform() >= albedo)
      return {false, 0};
    at = *hit;
    from = direction;
  }
}

double wrapped(double x) { return x - std::floor(x); }

CellLight traceCell(const RayTree& tree, const ProjectionFrame& frame, const SeenCell& cell,
                    const PathTraceOptions& options, Random& random) {
  const std::array<double, 4> shift{random.uniform(), random.uniform(), random.uniform(), random.uniform()};
  double sky = 0, sum = 0, squares = 0;
  for (int i = 1; i <= options.paths; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const std::array<double, 2> place = halton23(index);
    const Vec2 at = cell.min + (cell.max - cell.min) * Vec2(wrapped(place[0] + shift[0]), wrapped(place[1] + shift[1]));
    const Vec3 ray = frame.rayDirection(at);
    const auto hit = tree.firstHit(frame.eye(), ray);
    Path path{true, 1};
    if (hit)
      path = trace(tree, *hit, ray,
                   {wrapped(radicalInverse(index, 5) + shift[2]), wrapped(radicalInverse(index, 7) + shift[3])},
                   options.albedo, random);
    sky += path.seesSky;
    sum += path.luminance;
    squares += path.luminance * path.luminance;
  }
  const double mean = sum / options.paths;
  return {sky / options.paths, mean, std::sqrt(std::max(0.0, squares / options.paths - mean * mean) / options.paths)};
}

}  // namespace

std::vector<CellLight> traceCells(const RayTree& tree, const ProjectionFrame& frame, std::span<const SeenCell> cells,
                                  const PathTraceOptions& options) {
  std::vector<CellLight> light;
  light.reserve(cells.size());
  Random random(options.seed);
  for (const SeenCell& cell : cells) light.push_back(traceCell(tree, frame, cell, options, random));
  return light;
}

}  // namespace qrelief
