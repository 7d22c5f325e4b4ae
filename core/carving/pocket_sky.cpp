// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/pocket_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/grid_march.h"

namespace qrelief {
namespace {

constexpr double kSettledMm = 2e-3;
constexpr int kSteps = 24;
// Where on a floor, in its width: Gauss and Legendre's two. (A low step beside it hardly darkens its middle.)
constexpr double kPlaces[2] = {0.2113, 0.7887};

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
      const Vec2 place(kPlaces[k % 2], kPlaces[(k + k / 2) % 2]);
      GridMarch march({column, row}, place, {std::cos(angle), std::sin(angle)});
      for (std::uint32_t floor = 0; floor != kLight;) {
        const double distanceMm = march.step() * submoduleMm;
        const glm::ivec2 cell = march.cell();
        const bool inside = cell.x >= 0 && cell.y >= 0 && cell.x < mask.size && cell.y < mask.size;
        floor = inside ? floorOf[static_cast<std::size_t>(cell.y * mask.size + cell.x)] : kLight;
        steps_.push_back({floor, static_cast<float>(1 / distanceMm)});
      }
    }
  }
  begin_.push_back(static_cast<std::uint32_t>(steps_.size()));
  listSeenFrom();
}

/// The steps the other way round.
void PocketSky::listSeenFrom() {
  seenFromBegin_.assign(carved_.size() + 1, 0);
  for (const Step& step : steps_)
    if (step.floor != kLight) ++seenFromBegin_[step.floor + 1];
  for (std::size_t k = 0; k < carved_.size(); ++k) seenFromBegin_[k + 1] += seenFromBegin_[k];
  seenFrom_.resize(seenFromBegin_.back());
  std::vector<std::uint32_t> next(seenFromBegin_.begin(), seenFromBegin_.end() - 1);
  for (std::size_t k = 0; k < carved_.size(); ++k)
    for (std::uint32_t s = begin_[k * kDirections]; s < begin_[(k + 1) * kDirections]; ++s)
      if (steps_[s].floor != kLight) seenFrom_[next[steps_[s].floor]++] = static_cast<std::uint32_t>(k);
}

double PocketSky::fraction(std::size_t k, double depthMm, std::span<const double> depthsMm) const {
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

/// Fraction of the sky at a depth, and its change per mm of it.
PocketSky::FractionAndSlope PocketSky::fractionAndSlope(std::size_t k, double depthMm,
                                                        std::span<const double> depthsMm) const {
  FractionAndSlope sum;
  for (std::size_t direction = k * kDirections; direction < (k + 1) * kDirections; ++direction) {
    double steepest = 0, perMm = 0;
    for (std::uint32_t s = begin_[direction]; s < begin_[direction + 1]; ++s) {
      const double top = steps_[s].floor == kLight ? 0 : depthsMm[steps_[s].floor];
      const auto inverse = static_cast<double>(steps_[s].inverseDistanceMm);
      const double steep = (depthMm - top) * inverse;
      perMm = steep > steepest ? inverse : perMm;
      steepest = std::max(steepest, steep);
    }
    const double seen = 1 / (1 + steepest * steepest);
    sum.fraction += seen / kDirections;
    sum.perMm -= 2 * steepest * perMm * seen * seen / kDirections;
  }
  return sum;
}

/// By Newton's steps in log h and y = log((1 − V)/V), in which a pocket whose walls are all of one height is a line of
/// slope 2; between the depths that are known to be too bright and dark enough.
double PocketSky::depthFor(std::size_t k, double wanted, double limitMm, std::span<const double> depthsMm) const {
  double low = 0, high = limitMm;
  double depth = std::clamp(depthsMm[k], std::min(kSettledMm, limitMm), limitMm);
  for (int i = 0; i < kSteps; ++i) {
    const FractionAndSlope seen = fractionAndSlope(k, depth, depthsMm);
    if (seen.fraction > wanted) {
      if (depth >= limitMm) return limitMm;
      low = depth;
    } else {
      high = depth;
    }
    const double v = std::clamp(seen.fraction, 1e-9, 1 - 1e-9);
    const double perLogDepth = -seen.perMm * depth / (v * (1 - v));
    const double wantedMore = std::log((1 - wanted) / wanted * v / (1 - v));
    double next = perLogDepth > 0 ? depth * std::exp(wantedMore / perLogDepth) : high;
    if (next > high && high >= limitMm && low == depth) next = limitMm;
    if (!(next > low && next < high) && next != limitMm) next = (low + high) / 2;
    if (std::abs(next - depth) < kSettledMm / 4 || high - low < kSettledMm / 4) return std::min(next, limitMm);
    depth = next;
  }
  return high;
}

void PocketSky::solve(std::span<const double> fractions, std::span<const double> limitsMm, std::span<double> depthsMm,
                      std::vector<char> isDue, int maxSweeps) const {
  for (int sweep = 0; sweep < maxSweeps; ++sweep) {
    bool moved = false;
    for (std::size_t i = 0; i < carved_.size(); ++i) {
      const std::size_t k = sweep % 2 == 0 ? i : carved_.size() - 1 - i;  // there and back
      if (!isDue[k]) continue;
      isDue[k] = 0;
      const double depth = depthFor(k, fractions[k], limitsMm[k], depthsMm);
      const double change = std::abs(depth - depthsMm[k]);
      depthsMm[k] = depth;
      if (change < kSettledMm) continue;
      moved = true;
      for (const std::uint32_t other : seenFrom(k)) isDue[other] = 1;
    }
    if (!moved) return;
  }
}

}  // namespace qrelief
