// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/shaped_floor_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "depth/light_neighbours.h"

namespace qrelief::study {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr double kFirstDepthModules = 0.35;
constexpr double kLeastSlope = 2;  // slope of darkness over the logarithm of depth if all modules move
constexpr double kSlope = 3;       // assumed slope; for a single module moving in a dark area it would be 4 or more
constexpr double kAim = 0.02;      // extra darkness to aim at, beyond the required darkness
constexpr int kFreePasses = 8;     // after these passes no depth decreases, so the search ends

/// log((1 − V)/V)
double darkness(double fraction) {
  const double v = std::clamp(fraction, 1e-3, 1 - 1e-3);
  return std::log((1 - v) / v);
}

/// First carved row of a module's submodules, and the number of rows to the last one.
struct CarvedRows {
  int first = kN, count = 0;
};

CarvedRows carvedRows(const SubmoduleMask& mask, int moduleRow, int moduleColumn) {
  CarvedRows rows;
  for (int k = 0; k < kN * kN; ++k) {
    if (!mask.at(moduleRow * kN + k / kN, moduleColumn * kN + k % kN)) continue;
    rows.first = std::min(rows.first, k / kN);
    rows.count = k / kN - rows.first + 1;
  }
  return rows;
}

}  // namespace

const char* floorShapeName(FloorShape shape) {
  constexpr std::array<const char*, 3> kNames = {"flat", "tilted", "wavy"};
  return kNames[static_cast<std::size_t>(shape)];
}

double floorWeight(FloorShape shape, int moduleRow, int step, int steps) {
  if (shape == FloorShape::Flat) return 1;
  const bool isMirrored = shape == FloorShape::Wavy && moduleRow % 2 != 0;
  return static_cast<double>(isMirrored ? steps - step : step + 1) / steps;
}

ShapedFloorSearch::ShapedFloorSearch(CarvingTarget target, const ShapedFloorOptions& options)
    : target_(std::move(target)), options_(options), neighbours_(*target_.symbol) {
  const Symbol& symbol = *target_.symbol;
  const SubmoduleMask& mask = *target_.mask;
  depths_ = {mask.rows(), target_.symbolMm, std::vector<double>(mask.size(), 0)};
  contrast_.assign(symbol.dark.size(), 0);
  for (int row = 0; row < symbol.size; ++row) {
    for (int column = 0; column < symbol.size; ++column) {
      const CarvedRows rows = carvedRows(mask, row, column);
      if (rows.count == 0) continue;
      Floor floor;
      floor.module = static_cast<std::size_t>(row * symbol.size + column);
      for (int k = 0; k < kN * kN; ++k) {
        const auto i = static_cast<std::uint32_t>((row * kN + k / kN) * mask.rows() + column * kN + k % kN);
        if (!mask[i]) continue;
        const double weight = floorWeight(options_.shape, row, k / kN - rows.first, rows.count);
        floor.steps.push_back({i, weight});
        floor.limitMm = std::max(floor.limitMm, target_.limitMm[i] / weight);
      }
      floor.depthMm = std::min(kFirstDepthModules * target_.symbolMm / symbol.size, floor.limitMm);
      carve(floor);
      floors_.push_back(std::move(floor));
    }
  }
}

void ShapedFloorSearch::carve(const Floor& floor) {
  for (const Step& step : floor.steps)
    depths_.depthMm[step.submodule] =
        quantisedDepth(std::max(floor.depthMm * step.weight, kDepthQuantumMm), target_.limitMm[step.submodule]);
}

/// @param fraction  luminance as a fraction of the surroundings' luminance
void ShapedFloorSearch::judge(Floor& floor, double fraction) {
  const double asked = darkness(1 - options_.contrast), found = darkness(fraction);
  if (fraction > 1 - options_.contrast) {
    floor.state = floor.depthMm < floor.limitMm ? State::TooBright : State::Limited;
    if (floor.state == State::TooBright) floor.depthMm *= std::exp(std::min((asked + kAim - found) / kSlope, 1.0));
  } else {
    const double less = floor.depthMm - options_.slackMm;
    const bool isTooDeep = less > 0 && found - asked > kAim + kLeastSlope * std::log(floor.depthMm / less);
    floor.state = isTooDeep && iterations_ < kFreePasses ? State::TooDeep : State::Done;
    if (floor.state == State::TooDeep) floor.depthMm *= std::exp((asked + kAim - found) / kSlope);
  }
}

void ShapedFloorSearch::update(const Grid<double>& luminance) {
  const Grid<double> modules = moduleMeans(luminance);
  bool moved = false;
  for (Floor& floor : floors_) {
    double sum = 0;
    for (const Step& step : floor.steps)
      sum += luminanceOf(luminance, static_cast<int>(step.submodule) / depths_.size,
                         static_cast<int>(step.submodule) % depths_.size);
    const double around = neighbours_.darkestMean(floor.module, modules);
    const double fraction = sum / static_cast<double>(floor.steps.size()) / around;
    contrast_[floor.module] = 1 - fraction;
    const double before = floor.depthMm;
    judge(floor, fraction);
    // Moves by at least a quantum; otherwise nothing would move.
    if (floor.state == State::TooBright)
      floor.depthMm = std::min(std::max(floor.depthMm, before + kDepthQuantumMm), floor.limitMm);
    moved = moved || floor.depthMm != before;
  }
  ++iterations_;
  finished_ = !moved || iterations_ >= options_.maxIterations;
  if (!finished_)
    for (const Floor& floor : floors_) carve(floor);
}

double ShapedFloorSearch::doneFraction() const {
  const auto done = std::count_if(floors_.begin(), floors_.end(), [](const Floor& floor) {
    return floor.state == State::Done || floor.state == State::Limited;
  });
  return floors_.empty() ? 1 : static_cast<double>(done) / static_cast<double>(floors_.size());
}

std::size_t ShapedFloorSearch::limitedCount() const {
  std::size_t count = 0;
  for (const Floor& floor : floors_)
    if (floor.state == State::Limited) count += floor.steps.size();
  return count + unfinishedCount();
}

std::size_t ShapedFloorSearch::unfinishedCount() const {
  std::size_t count = 0;
  for (const Floor& floor : floors_)
    if (finished_ && floor.state == State::TooBright) count += floor.steps.size();
  return count;
}

}  // namespace qrelief::study
