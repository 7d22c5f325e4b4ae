// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/pocket_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qrelief {
namespace {

constexpr double kSettledMm = 0.002;
constexpr int kMaxSweeps = 200;
constexpr int kBisections = 12;

}  // namespace

PocketSky::PocketSky(const SubmoduleMask& mask, double submoduleMm) {
  std::vector<std::uint32_t> floorOf(mask.carved.size(), kLight);
  for (std::uint32_t i = 0; i < mask.carved.size(); ++i) {
    if (!mask.carved[i]) continue;
    floorOf[i] = static_cast<std::uint32_t>(carved_.size());
    carved_.push_back(i);
  }
  for (const std::uint32_t i : carved_) {
    const int row = static_cast<int>(i) / mask.size, column = static_cast<int>(i) % mask.size;
    for (int k = 0; k < kDirections; ++k) {
      begin_.push_back(static_cast<std::uint32_t>(steps_.size()));
      // Between the axes and the diagonals.
      const double angle = 2 * std::numbers::pi * (k + 0.5) / kDirections;
      const double along[2] = {std::cos(angle), std::sin(angle)};
      int cell[2] = {column, row};
      double next[2] = {0.5 / std::abs(along[0]), 0.5 / std::abs(along[1])};
      for (std::uint32_t floor = 0; floor != kLight;) {
        const int axis = next[0] < next[1] ? 0 : 1;
        const double distanceMm = next[axis] * submoduleMm;
        next[axis] += 1 / std::abs(along[axis]);
        cell[axis] += along[axis] > 0 ? 1 : -1;
        const bool inside = cell[0] >= 0 && cell[1] >= 0 && cell[0] < mask.size && cell[1] < mask.size;
        floor = inside ? floorOf[static_cast<std::size_t>(cell[1] * mask.size + cell[0])] : kLight;
        steps_.push_back({floor, static_cast<float>(1 / distanceMm)});
      }
    }
  }
  begin_.push_back(static_cast<std::uint32_t>(steps_.size()));
}

double PocketSky::share(std::size_t k, double depthMm, std::span<const double> depthsMm) const {
  double sum = 0;
  for (std::size_t direction = k * kDirections; direction < (k + 1) * kDirections; ++direction) {
    double steepest = 0;  // tangent of the horizon's elevation
    for (std::uint32_t s = begin_[direction]; s < begin_[direction + 1]; ++s) {
      const double top = steps_[s].floor == kLight ? 0 : depthsMm[steps_[s].floor];
      steepest = std::max(steepest, (depthMm - top) * static_cast<double>(steps_[s].inverseDistanceMm));
    }
    sum += 1 / (1 + steepest * steepest);
  }
  return sum / kDirections;
}

double PocketSky::depthFor(std::size_t k, double wanted, double limitMm, std::span<const double> depthsMm) const {
  if (share(k, limitMm, depthsMm) > wanted) return limitMm;
  // A bracket around the depth of the last sweep first: mostly it has hardly moved.
  double low = 0, high = limitMm;
  for (double width = 4 * kSettledMm; width < limitMm; width *= 4) {
    const double below = std::max(0.0, depthsMm[k] - width), above = std::min(limitMm, depthsMm[k] + width);
    if (share(k, below, depthsMm) > wanted) low = std::max(low, below);
    if (share(k, above, depthsMm) <= wanted) high = std::min(high, above);
    if (low == below && high == above) break;
  }
  for (int i = 0; i < kBisections && high - low > kSettledMm / 4; ++i) {
    const double middle = (low + high) / 2;
    (share(k, middle, depthsMm) > wanted ? low : high) = middle;
  }
  return high;
}

void PocketSky::solve(std::span<const double> shares, std::span<const double> limitsMm,
                      std::span<double> depthsMm) const {
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    double moved = 0;
    for (std::size_t i = 0; i < carved_.size(); ++i) {
      const std::size_t k = sweep % 2 == 0 ? i : carved_.size() - 1 - i;  // there and back
      const double depth = depthFor(k, shares[k], limitsMm[k], depthsMm);
      moved = std::max(moved, std::abs(depth - depthsMm[k]));
      depthsMm[k] = depth;
    }
    if (moved < kSettledMm) return;
  }
}

}  // namespace qrelief
