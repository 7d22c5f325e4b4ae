// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/path_tracer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/halton.h"
#include "base/parallel.h"
#include "base/random.h"

namespace qrelief {
namespace {

constexpr double kLeaveSurfaceMm = 1e-6;  // along the new direction, so that a path does not hit where it starts
constexpr int kSureBounces = 3;
constexpr int kEstimates = 8;

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

/// A lamp in model space.
struct Lamp {
  Vec3 towards;
  double strength;
};

double lampIrradiance(const RayTree& tree, Vec3 at, Vec3 normal, std::span<const Lamp> lamps) {
  double sum = 0;
  for (const Lamp& lamp : lamps) {
    const double cosine = glm::dot(normal, lamp.towards);
    if (cosine > 0 && !tree.firstHit(at, lamp.towards, kLeaveSurfaceMm)) sum += lamp.strength * cosine;
  }
  return sum;
}

struct Path {
  bool seesSky = false;
  double direct = 0, irradiance = 0;
};

/// From a point that the eye sees in direction `from`.
Path trace(const RayTree& tree, SurfacePoint at, Vec3 from, std::array<double, 2> first, double albedo,
           std::span<const Lamp> lamps, Random& random) {
  double throughput = 1;
  Path path;
  for (int bounce = 0;; ++bounce) {
    const Vec3 normal = facing(tree.mesh(), at, from);
    const double lamp = lampIrradiance(tree, at.position, normal, lamps);
    if (bounce == 0) path.direct = lamp;
    path.irradiance += throughput * lamp;
    const double u = bounce == 0 ? first[0] : random.uniform();
    const double v = bounce == 0 ? first[1] : random.uniform();
    const Vec3 direction = cosineDirection(normal, u, v);
    const auto hit = tree.firstHit(at.position, direction, kLeaveSurfaceMm);
    if (!hit) {
      path.seesSky = bounce == 0;
      path.irradiance += throughput;
      return path;
    }
    if (bounce < kSureBounces)
      throughput *= albedo;
    else if (random.uniform() >= albedo)
      return path;
    at = *hit;
    from = direction;
  }
}

double wrapped(double x) { return x - std::floor(x); }

struct Sums {
  double sky = 0, direct = 0, irradiance = 0;
};

/// Means over one set of Halton points with one random shift.
Sums estimate(const RayTree& tree, const ProjectionFrame& frame, const SeenCell& cell, std::span<const Lamp> lamps,
              double open, int paths, double albedo, Random& random) {
  const std::array<double, 4> shift{random.uniform(), random.uniform(), random.uniform(), random.uniform()};
  Sums sums;
  for (int i = 1; i <= paths; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const std::array<double, 2> place = halton23(index);
    const Vec2 at = cell.min + (cell.max - cell.min) * Vec2(wrapped(place[0] + shift[0]), wrapped(place[1] + shift[1]));
    const Vec3 ray = frame.rayDirection(at);
    const auto hit = tree.firstHit(frame.eye(), ray);
    Path path{true, open - 1, open};
    if (hit)
      path = trace(tree, *hit, ray,
                   {wrapped(radicalInverse(index, 5) + shift[2]), wrapped(radicalInverse(index, 7) + shift[3])}, albedo,
                   lamps, random);
    sums.sky += path.seesSky;
    sums.direct += path.direct;
    sums.irradiance += path.irradiance;
  }
  return {sums.sky / paths, sums.direct / paths, sums.irradiance / paths};
}

Traced summarised(const std::array<double, kEstimates>& values) {
  double mean = 0, squares = 0;
  for (const double value : values) mean += value / kEstimates;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / (kEstimates * (kEstimates - 1)))};
}

CellLight traceCell(const RayTree& tree, const ProjectionFrame& frame, const SeenCell& cell,
                    std::span<const Lamp> lamps, double open, const PathTraceOptions& options, std::uint64_t seed) {
  Random random(seed);
  std::array<double, kEstimates> sky{}, direct{}, luminance{};
  for (std::size_t k = 0; k < kEstimates; ++k) {
    const Sums sums = estimate(tree, frame, cell, lamps, open, options.paths / kEstimates, options.albedo, random);
    sky[k] = sums.sky;
    direct[k] = sums.direct;
    luminance[k] = sums.irradiance / open;
  }
  return {summarised(sky), summarised(direct), summarised(luminance)};
}

}  // namespace

std::vector<CellLight> traceCells(const RayTree& tree, const ProjectionFrame& frame, std::span<const SeenCell> cells,
                                  const PathTraceOptions& options) {
  assert(options.paths >= kEstimates);
  std::vector<Lamp> lamps;
  for (const DirectionalLight& light : options.lights) {
    const Vec3 to = towards(light);
    lamps.push_back({frame.right * to.x + frame.up * to.y + frame.normal * to.z, light.strength});
  }
  std::vector<std::uint64_t> seeds(cells.size());
  Random random(options.seed);
  for (std::uint64_t& seed : seeds) seed = random.next();
  std::vector<CellLight> light(cells.size());
  const double open = openIrradiance(options.lights);
  parallelFor(cells.size(),
              [&](std::size_t i) { light[i] = traceCell(tree, frame, cells[i], lamps, open, options, seeds[i]); });
  return light;
}

}  // namespace qrelief
