// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/pocket_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "math/grid_march.h"

namespace qrelief {
namespace {

constexpr double kSettledMm = 2e-3, kShortStepMm = 1e-2;
constexpr int kSteps = 24;
constexpr std::size_t kMostGroups = 16;
// Positions on a floor, in its width: the two-point Gauss–Legendre nodes. (A low step next to a floor hardly darkens
// its middle.)
constexpr double kPlaces[2] = {0.2113, 0.7887};

}  // namespace

std::array<std::vector<PathStep>, kFloorDirections> floorPaths(int size, double submoduleMm) {
  std::array<std::vector<PathStep>, kFloorDirections> paths;
  for (std::size_t k = 0; k < kFloorDirections; ++k) {
    // Between the axes and the diagonals.
    const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / kFloorDirections;
    const Vec2 place(kPlaces[k % 2], kPlaces[(k + k / 2) % 2]);
    GridMarch march({0, 0}, place, {std::cos(angle), std::sin(angle)});
    for (;;) {
      const double distanceMm = march.step() * submoduleMm;
      if (std::max(std::abs(march.cell().x), std::abs(march.cell().y)) > size) break;
      paths[k].push_back({march.cell(), static_cast<float>(1 / distanceMm)});
    }
  }
  return paths;
}

PocketSky::PocketSky(const SubmoduleMask& mask, double submoduleMm) {
  const int stride = mask.rows() + 2, beyond = mask.rows() * stride + mask.rows();  // offset of the farthest step
  floorOf_.assign(static_cast<std::size_t>(stride * stride + 2 * beyond), kLight);
  for (std::uint32_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    const int row = static_cast<int>(i) / mask.rows(), column = static_cast<int>(i) % mask.rows();
    cell_.push_back(static_cast<std::uint32_t>(beyond + (row + 1) * stride + column + 1));
    floorOf_[cell_.back()] = static_cast<std::uint32_t>(carved_.size());
    carved_.push_back(i);
  }
  const std::array<std::vector<PathStep>, kFloorDirections> paths = floorPaths(mask.rows(), submoduleMm);
  for (std::size_t k = 0; k < kFloorDirections; ++k) {
    for (std::size_t step = 0; step < paths[k].size(); ++step) {
      const std::size_t i = step * kFloorDirections + k;
      if (i >= steps_.offset.size()) {
        steps_.offset.resize((step + 1) * kFloorDirections, 0);
        steps_.perMm.resize(steps_.offset.size(), 0);
      }
      steps_.offset[i] = paths[k][step].cell.y * stride + paths[k][step].cell.x;
      steps_.perMm[i] = paths[k][step].perMm;
    }
  }
  findGroups();
}

void PocketSky::findGroups() {
  constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<std::uint32_t> groupOf(carved_.size(), kNone);
  std::vector<std::uint32_t> open;
  const std::size_t enough = (carved_.size() + kMostGroups - 1) / kMostGroups;
  for (std::uint32_t start = 0; start < groupOf.size(); ++start) {
    if (groupOf[start] != kNone) continue;
    if (groups_.empty() || groups_.back().size() >= enough) groups_.emplace_back();
    const auto group = static_cast<std::uint32_t>(groups_.size() - 1);
    const auto add = [&](std::uint32_t floor) {
      if (groupOf[floor] != kNone) return;
      groupOf[floor] = group;
      groups_[group].push_back(floor);
      open.push_back(floor);
    };
    add(start);
    while (!open.empty()) {
      const std::uint32_t floor = open.back();
      open.pop_back();
      forEachInSight(floor, add);
    }
  }
  for (std::vector<std::uint32_t>& group : groups_) std::sort(group.begin(), group.end());
}

/// Spreads the floors' values over the grid; 0 in light cells.
std::vector<float> PocketSky::onGrid(std::span<const double> values) const {
  std::vector<float> grid(floorOf_.size(), 0);
  for (std::size_t k = 0; k < cell_.size(); ++k) grid[cell_[k]] = static_cast<float>(values[k]);
  return grid;
}

/// Finds the depth at which a floor sees the wanted fraction. It takes Newton steps in log h and y = log((1 − V)/V), in
/// which a pocket with walls of equal height is a line of slope 2. The steps stay between the depths known to be too
/// bright and dark enough.
double PocketSky::depthFor(std::size_t k, double fraction, double limitMm, const std::vector<float>& grid) const {
  double low = 0, high = limitMm;
  double depth = std::clamp(static_cast<double>(grid[cell_[k]]), std::min(kSettledMm, limitMm), limitMm);
  for (int i = 0; i < kSteps; ++i) {
    const SkySeen seen = skySeenFrom(&grid[cell_[k]], static_cast<float>(depth), steps_);
    if (seen.fraction > fraction) {
      if (depth >= limitMm) return limitMm;
      low = depth;
    } else {
      high = depth;
    }
    const double v = std::clamp(seen.fraction, 1e-9, 1 - 1e-9);
    const double perLogDepth = -seen.perMm * depth / (v * (1 - v));
    const double wantedMore = std::log((1 - fraction) / fraction * v / (1 - v));
    double next = perLogDepth > 0 ? depth * std::exp(wantedMore / perLogDepth) : high;
    if (next > high && high >= limitMm && low == depth) next = limitMm;
    const bool isStep = (next > low && next < high) || next == limitMm;
    if (!isStep) next = (low + high) / 2;
    // The error of a short Newton step is of the order of its square.
    if (std::abs(next - depth) < (isStep ? kShortStepMm : kSettledMm / 4) || high - low < kSettledMm / 4)
      return std::min(next, limitMm);
    depth = next;
  }
  return high;
}

void PocketSky::solve(std::span<const double> fractions, std::span<const double> limitsMm, std::span<double> depthsMm,
                      std::vector<char> isDue, int maxSweeps) const {
  const std::vector<float> start = onGrid(depthsMm);
  parallelFor(groups_.size(), [&](std::size_t number) {
    const std::vector<std::uint32_t>& group = groups_[number];
    std::vector<float> grid = start;
    for (int sweep = 0; sweep < maxSweeps; ++sweep) {
      bool moved = false;
      for (std::size_t i = 0; i < group.size(); ++i) {
        const std::uint32_t k = group[sweep % 2 == 0 ? i : group.size() - 1 - i];  // there and back
        if (!isDue[k]) continue;
        isDue[k] = 0;
        const double depth = depthFor(k, fractions[k], limitsMm[k], grid);
        const double change = std::abs(depth - depthsMm[k]);
        depthsMm[k] = depth;
        grid[cell_[k]] = static_cast<float>(depth);
        if (change < kSettledMm) continue;
        moved = true;
        forEachInSight(k, [&](std::uint32_t other) { isDue[other] = 1; });
      }
      if (!moved) return;
    }
  });
}

}  // namespace qrelief
