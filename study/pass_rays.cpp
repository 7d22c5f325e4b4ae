// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/pass_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace qrelief::study {

PassRays::PassRays(std::vector<std::uint32_t> submodules, std::size_t rays)
    : submodules_(std::move(submodules)), rays_(rays), known_(submodules_.size() * rays) {}

void PassRays::begin(const ProjectionFrame& frame, const DepthField& depths) {
  frame_ = frame;
  const int size = depths.size;
  hasMoved_.assign(depths.depthMm.size(), 1);
  for (std::size_t i = 0; i < depths_.depthMm.size(); ++i) hasMoved_[i] = depths.depthMm[i] != depths_.depthMm[i];
  depths_ = depths;
  isNearMoved_.assign(hasMoved_.size(), 0);
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      if (!hasMoved_[static_cast<std::size_t>(row * size + column)]) continue;
      for (int r = std::max(0, row - 1); r <= std::min(size - 1, row + 1); ++r)
        for (int c = std::max(0, column - 1); c <= std::min(size - 1, column + 1); ++c)
          isNearMoved_[static_cast<std::size_t>(r * size + c)] = 1;
    }
}

std::int32_t PassRays::submoduleOf(Vec3 point) const {
  if (frame_.distanceAlongAxis(point) <= 0) return kBesideCode;
  const Vec2 fromCorner = (frame_.project(point) - depths_.corner(0, 0)) / depths_.submoduleMm();
  const double column = std::floor(fromCorner.x), row = std::floor(-fromCorner.y);
  if (!(row >= 0 && column >= 0 && row < depths_.size && column < depths_.size)) return kBesideCode;
  return static_cast<std::int32_t>(row) * depths_.size + static_cast<std::int32_t>(column);
}

bool overHemisphere(PassRays& rays, const CarvedSurface& surface, std::size_t k, std::size_t count, std::uint64_t seed,
                    const std::function<void(double, const std::optional<double>&)>& tell) {
  const auto at = surface.middleOf(rays.submodules()[k]);
  if (!at) return false;
  const Hemisphere hemisphere(surface.normalAt(*at), seed);
  for (std::size_t i = 0; i < count; ++i) {
    const double cosine = hemisphere.cosine(i);
    const double distanceMm = rays.value(k, i, [&]() -> PassRays::Cast {
      const auto hit = surface.hitFrom(*at, hemisphere.direction(i));
      if (!hit) return {std::numeric_limits<double>::infinity(), std::nullopt};
      return {glm::length(hit->position - at->position), hit->position};
    });
    tell(cosine, std::isinf(distanceMm) ? std::nullopt : std::optional(distanceMm));
  }
  return true;
}

double measureUntilClear(std::size_t rays, double target, double margin,
                         const std::function<double(std::size_t)>& measure) {
  for (std::size_t count = std::max<std::size_t>(1, rays / 8); count < rays; count *= 2, margin /= 2)
    if (const double value = measure(count); value > target + margin) return value;
  return measure(rays);
}

std::optional<SkySeen> skySeen(PassRays& rays, const CarvedSurface& surface, std::size_t k, std::size_t count,
                               std::uint64_t seed) {
  SkySeen seen;
  const auto all = static_cast<double>(count);
  const bool isSeen =
      overHemisphere(rays, surface, k, count, seed, [&](double cosine, const std::optional<double>& distanceMm) {
        if (distanceMm) return;
        seen.cosineWeighted += 2 * cosine / all;
        seen.solidAngle += 2 * std::numbers::pi / all;
      });
  return isSeen ? std::optional(seen) : std::nullopt;
}

}  // namespace qrelief::study
