// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/lamp_hemisphere.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace qrelief {
namespace {

constexpr double kLowestDeg = 1;    // a lamp in the QR plane lights no code
constexpr double kOverhead = 1e-3;  // nearer to the axis, in radii, a place tells no azimuth

/// Returns the two directions in which a ray meets the unit sphere about the origin; twice the nearest one if it
/// misses.
std::array<Vec3, 2> meetings(Vec3 origin, Vec3 direction) {
  const Vec3 closest = origin - direction * glm::dot(origin, direction);
  const double distance = glm::length(closest);
  if (distance >= 1) return {closest / distance, closest / distance};
  const Vec3 half = direction * std::sqrt(1 - distance * distance);
  return {closest - half, closest + half};
}

}  // namespace

Vec3 LampHemisphere::direction(const DirectionalLight& lamp) const {
  const Vec3 way = towards(lamp);
  return way.x * frame.right + way.y * frame.up + way.z * frame.normal;
}

DirectionalLight LampHemisphere::moved(const DirectionalLight& lamp, const Ray& ray) const {
  const auto [one, other] = meetings((ray.origin - frame.centre) / radiusMm, ray.direction);
  const double oneHeight = glm::dot(one, frame.normal), otherHeight = glm::dot(other, frame.normal);
  const Vec3 now = direction(lamp);
  const bool isOne = oneHeight > 0 && otherHeight > 0 ? glm::distance(one, now) <= glm::distance(other, now)
                                                      : oneHeight >= otherHeight;
  const Vec3 met = isOne ? one : other;
  const double right = glm::dot(met, frame.right), up = glm::dot(met, frame.up);
  DirectionalLight result = lamp;
  if (std::hypot(right, up) > kOverhead)
    result.azimuthDeg = std::round(toDegrees(std::atan2(up, right))) + 0.0;  // no -0
  if (result.azimuthDeg < 0) result.azimuthDeg += 360;
  const double height = std::clamp(isOne ? oneHeight : otherHeight, 0.0, 1.0);
  result.elevationDeg = std::max(kLowestDeg, std::round(toDegrees(std::asin(height))));
  return result;
}

}  // namespace qrelief
