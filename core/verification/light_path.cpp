// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/light_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/angle.h"

namespace qrelief {
namespace {

constexpr double kLeaveSurfaceMm = 1e-6;  // along the new direction, so that a path does not hit its own start
constexpr int kSureBounces = 3;

/// Returns a unit vector with `height` along the unit vector `axis`, turned round it by `turn`, 0 … 1 [axes: Duff et
/// al. 2017].
Vec3 directionAbout(Vec3 axis, double height, double turn) {
  const double sign = std::copysign(1.0, axis.z);
  const double a = -1 / (sign + axis.z);
  const double b = axis.x * axis.y * a;
  const Vec3 x{1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
  const Vec3 y{b, sign + axis.y * axis.y * a, -axis.y};
  const double radius = std::sqrt(std::max(0.0, 1 - height * height)), angle = 2 * std::numbers::pi * turn;
  return x * (radius * std::cos(angle)) + y * (radius * std::sin(angle)) + axis * height;
}

/// Returns the facet normal on the side that the ray comes from.
Vec3 facing(const RaySurface& surface, const SurfacePoint& at, Vec3 direction) {
  const Vec3 normal = surface.normalAt(at);
  return glm::dot(normal, direction) > 0 ? -normal : normal;
}

/// Returns the irradiance by one random point of each lamp's disc. Draws the random numbers even for a lamp that is
/// off, so that paths stay the same.
double lampIrradiance(const RaySurface& surface, Vec3 at, Vec3 normal, std::span<const Lamp> lamps, Random& random) {
  double sum = 0;
  for (const Lamp& lamp : lamps) {
    Vec3 to = lamp.towards;
    if (lamp.radiusDeg > 0) {
      const double edge = std::cos(toRadians(lamp.radiusDeg));
      const double height = 1 - random.uniform() * (1 - edge);
      to = directionAbout(lamp.towards, height, random.uniform());
    }
    if (lamp.strength <= 0) continue;
    const double cosine = glm::dot(normal, to);
    if (cosine > 0 && !surface.firstHit(at, to, kLeaveSurfaceMm)) sum += lamp.strength * cosine;
  }
  return sum;
}

}  // namespace

Lamp lampOf(const DirectionalLight& light, const ProjectionFrame& frame, double radiusDeg) {
  const Vec3 to = towards(light);
  return {frame.right * to.x + frame.up * to.y + frame.normal * to.z, light.strength, radiusDeg};
}

LightPath traceLight(const RaySurface& surface, SurfacePoint at, Vec3 seen, std::array<double, 2> first, double albedo,
                     std::span<const Lamp> lamps, Random& random) {
  LightPath path;
  double throughput = 1;
  for (int bounce = 0;; ++bounce) {
    const Vec3 normal = facing(surface, at, seen);
    const double lamp = lampIrradiance(surface, at.position, normal, lamps, random);
    if (bounce == 0) path.lampDirect = lamp;
    path.lamp += throughput * lamp;
    const double u = bounce == 0 ? first[0] : random.uniform();
    const double v = bounce == 0 ? first[1] : random.uniform();
    const Vec3 direction = directionAbout(normal, std::sqrt(1 - u), v);
    const auto hit = surface.firstHit(at.position, direction, kLeaveSurfaceMm);
    if (!hit) {
      path.seesSky = bounce == 0;
      path.sky = throughput;
      return path;
    }
    if (bounce < kSureBounces)
      throughput *= albedo;
    else if (random.uniform() >= albedo)
      return path;
    at = *hit;
    seen = direction;
  }
}

}  // namespace qrelief
