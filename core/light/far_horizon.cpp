// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/far_horizon.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/parallel.h"

namespace qrelief {
namespace {

constexpr double kGrowth = 1.15;  // growth of a step: surface narrower than a seventh of its distance may be missed
// Growth of a step towards a lamp, of at least a patch: a narrow part of the model already hides the whole lamp.
constexpr double kGrowthToLamp = 1.02;
// Patches at silhouettes have steep planes that lead far off the surface. Such a patch counts as level (as in
// shaders/distance_map.glsl).
constexpr float kSteepestPlane = 10;
constexpr double kSteepest = 100;
constexpr float kNowhere = 2 * HeightMap::kNothing;

/// Returns the height of the surface over a point of the plane; kNothing on a patch without surface, kNowhere outside
/// the map.
/// @param steepestPlane  slope from which a patch counts as level
float heightAt(const HeightMap& map, Vec2 point, float steepestPlane) {
  const Vec2 place = point / map.patchMm + Vec2(map.size / 2.0);
  const Vec2 patch = glm::floor(place);
  if (!(patch.x >= 0 && patch.y >= 0 && patch.x < map.size && patch.y < map.size)) return kNowhere;
  const auto i =
      static_cast<std::size_t>(patch.y) * static_cast<std::size_t>(map.size) + static_cast<std::size_t>(patch.x);
  if (!map.isSurface(i)) return HeightMap::kNothing;
  const glm::vec2 off((place - patch - 0.5) * map.patchMm);
  if (std::hypot(map.slopeX[i], map.slopeY[i]) > steepestPlane) return map.height[i];
  return map.height[i] + off.x * map.slopeX[i] + off.y * map.slopeY[i];
}

}  // namespace

FarHorizon farHorizonOf(const HeightMap& map, const HeightMap* around, double startMm, int places,
                        std::span<const DirectionalLight> lamps) {
  assert(lamps.size() <= kMaxLights);
  FarHorizon far{places, {}};
  const auto count = static_cast<std::size_t>(places) * static_cast<std::size_t>(places);
  far.cotangents.assign((FarHorizon::kDirections + lamps.size()) * count, static_cast<float>(-kSteepest));
  const double eye = map.eyeDistance;
  const double reachMm = (around ? around->size * around->patchMm : map.size * map.patchMm) * std::numbers::sqrt2;
  parallelFor(static_cast<std::size_t>(places), [&](std::size_t row) {
    for (int column = 0; column < places; ++column) {
      const auto patchOf = [&](double place) { return static_cast<int>((place + 0.5) * map.size / places); };
      const int patchRow = patchOf(static_cast<double>(row)), patchColumn = patchOf(column);
      const auto patch = static_cast<std::size_t>(patchRow * map.size + patchColumn);
      if (!map.isSurface(patch)) continue;
      const Vec2 at((patchColumn + 0.5 - map.size / 2.0) * map.patchMm,
                    (patchRow + 0.5 - map.size / 2.0) * map.patchMm);
      const double height = static_cast<double>(map.height[patch]);
      const auto find = [&](std::size_t direction, Vec2 along, double ownSlope, double growth, double leastStepMm,
                            float steepestPlane) {
        double slope = ownSlope;
        for (double distance = startMm; distance < reachMm;
             distance = std::max(distance * growth, distance + leastStepMm)) {
          const Vec2 point = at + along * distance;
          float seen = heightAt(map, point, steepestPlane);
          if (seen == kNowhere) seen = around ? heightAt(*around, point, steepestPlane) : kNowhere;
          if (seen == kNowhere) break;
          if (seen > HeightMap::kNothing) slope = std::max(slope, (static_cast<double>(seen) - height) / distance);
        }
        // Measured from the line of sight instead of the normal: see light_rows.h.
        const double forward = glm::dot(at, along), aside = glm::dot(at, Vec2(-along.y, along.x));
        const double cotangent =
            ((eye * eye + glm::dot(at, at)) / (height + eye) * slope - forward) / std::hypot(eye, aside);
        far.cotangents[direction * count + row * static_cast<std::size_t>(places) + static_cast<std::size_t>(column)] =
            static_cast<float>(std::clamp(cotangent, -kSteepest, kSteepest));
      };
      for (int k = 0; k < FarHorizon::kDirections; ++k) {
        const double angle = 2 * std::numbers::pi * k / FarHorizon::kDirections;
        const Vec2 along(std::cos(angle), std::sin(angle));
        const double ownSlope =
            static_cast<double>(map.slopeX[patch]) * along.x + static_cast<double>(map.slopeY[patch]) * along.y;
        find(static_cast<std::size_t>(k), along, ownSlope, kGrowth, 0, HUGE_VALF);
      }
      for (std::size_t lamp = 0; lamp < lamps.size(); ++lamp) {
        const Vec3 to = towards(lamps[lamp]);
        const Vec2 way = Vec2(to.x, to.y) + at * (to.z / eye);
        find(FarHorizon::kDirections + lamp, way / std::max(glm::length(way), 1e-9), -kSteepest, kGrowthToLamp,
             map.patchMm, kSteepestPlane);
      }
    }
  });
  return far;
}

}  // namespace qrelief
