// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/far_horizon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"

namespace qrelief {
namespace {

constexpr double kGrowth = 1.15;  // growth of a step: surface narrower than a seventh of its distance may be missed
constexpr double kSteepest = 100;
constexpr float kNowhere = 2 * HeightMap::kNothing;

/// Returns the height of the surface over a point of the plane; kNothing on a patch without surface, kNowhere outside
/// the map.
float heightAt(const HeightMap& map, Vec2 point) {
  const Vec2 place = point / map.patchMm + Vec2(map.size / 2.0);
  const Vec2 patch = glm::floor(place);
  if (!(patch.x >= 0 && patch.y >= 0 && patch.x < map.size && patch.y < map.size)) return kNowhere;
  const auto i =
      static_cast<std::size_t>(patch.y) * static_cast<std::size_t>(map.size) + static_cast<std::size_t>(patch.x);
  if (!map.isSurface(i)) return HeightMap::kNothing;
  const glm::vec2 off((place - patch - 0.5) * map.patchMm);
  return map.height[i] + off.x * map.slopeX[i] + off.y * map.slopeY[i];
}

}  // namespace

FarHorizon farHorizonOf(const HeightMap& map, const HeightMap* around, double startMm, int places) {
  FarHorizon far{places, {}};
  const auto count = static_cast<std::size_t>(places) * static_cast<std::size_t>(places);
  far.cotangents.assign(FarHorizon::kDirections * count, static_cast<float>(-kSteepest));
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
      for (int k = 0; k < FarHorizon::kDirections; ++k) {
        const double angle = 2 * std::numbers::pi * k / FarHorizon::kDirections;
        const Vec2 along(std::cos(angle), std::sin(angle));
        double slope =
            static_cast<double>(map.slopeX[patch]) * along.x + static_cast<double>(map.slopeY[patch]) * along.y;
        for (double distance = startMm; distance < reachMm; distance *= kGrowth) {
          const Vec2 point = at + along * distance;
          float seen = heightAt(map, point);
          if (seen == kNowhere) seen = around ? heightAt(*around, point) : kNowhere;
          if (seen == kNowhere) break;
          if (seen > HeightMap::kNothing) slope = std::max(slope, (static_cast<double>(seen) - height) / distance);
        }
        // Measured from the line of sight instead of the normal: see light_rows.h.
        const double forward = glm::dot(at, along), aside = glm::dot(at, Vec2(-along.y, along.x));
        const double cotangent =
            ((eye * eye + glm::dot(at, at)) / (height + eye) * slope - forward) / std::hypot(eye, aside);
        far.cotangents[static_cast<std::size_t>(k) * count + row * static_cast<std::size_t>(places) +
                       static_cast<std::size_t>(column)] =
            static_cast<float>(std::clamp(cotangent, -kSteepest, kSteepest));
      }
    }
  });
  return far;
}

}  // namespace qrelief
