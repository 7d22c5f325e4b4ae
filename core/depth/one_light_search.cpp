// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/one_light_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "depth/light_neighbours.h"
#include "math/angle.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr double kGrowth = 0.2;  // growth of a fraction in shadow per pass
// Least sine of the lamp's elevation: at flatter angles nonexistent rims would cast shadows.
constexpr double kLeastSine = 0.05;
constexpr int kSamples = 16;    // samples of a submodule, each in a row and a column of its own
constexpr int kSampleTurn = 7;  // coprime to kSamples: distance between the samples of neighbouring rows

/// Returns the quantile of evenly spread values: the value below which the fraction `f` of them lies, continued
/// linearly.
/// @param values  ascending, the middles of equal parts
double quantile(const std::array<double, kSamples>& values, double f) {
  const double at = std::clamp(f * kSamples - 0.5, 0.0, kSamples - 1.0);
  const auto i = static_cast<std::size_t>(std::min(at, kSamples - 2.0));
  const double slope = values[i + 1] - values[i];
  return values[i] + (f * kSamples - 0.5 - static_cast<double>(i)) * slope;
}

}  // namespace

double shadowFraction(double contrast, double irradiance) {
  return irradiance > 0 ? std::min(contrast * (1 + irradiance) / irradiance, 1.0) : 1;
}

double shadowDepth(double contrast, const DirectionalLight& lamp) {
  const double sine = std::sin(toRadians(lamp.elevationDeg));
  return shadowFraction(contrast, lamp.strength * sine) * std::tan(toRadians(lamp.elevationDeg));
}

OneLightSearch::OneLightSearch(CarvingTarget target, const OneLightOptions& options)
    : target_(std::move(target)), options_(options), neighbours_(*target_.symbol) {
  const SubmoduleMask& mask = *target_.mask;
  const double azimuth = toRadians(options_.lamp.azimuthDeg);
  towardsLamp_ = {std::cos(azimuth), -std::sin(azimuth)};
  depths_ = {mask.rows(), target_.symbolMm, std::vector<double>(mask.size(), 0)};
  const double sine = std::sin(toRadians(options_.lamp.elevationDeg));
  for (std::uint32_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    const int row = static_cast<int>(i) / mask.rows(), column = static_cast<int>(i) % mask.rows();
    Floor floor{.submodule = i, .module = static_cast<std::size_t>(row / kN * target_.symbol->size + column / kN)};
    takeElevation(floor, options_.lamp.strength * sine);
    floors_.push_back(floor);
  }
  const auto behind = [&](const Floor& floor) {
    const Vec2 at(static_cast<int>(floor.submodule) % mask.rows(), static_cast<int>(floor.submodule) / mask.rows());
    return -glm::dot(at, towardsLamp_);
  };
  std::stable_sort(floors_.begin(), floors_.end(),
                   [&](const Floor& a, const Floor& b) { return behind(a) < behind(b); });
  solve();
}

/// @param irradiance  irradiance of its surroundings by the lamp
void OneLightSearch::takeElevation(Floor& floor, double irradiance) const {
  const double sine = options_.lamp.strength > 0 ? std::min(irradiance / options_.lamp.strength, 1.0) : 0;
  floor.fraction = shadowFraction(options_.contrast, irradiance);
  floor.tangent = sine < kLeastSine ? 0 : sine / std::sqrt(std::max(1 - sine * sine, 1e-6));
}

/// Returns the depth that a floor needs on a plane, given the depths towards the lamp.
double OneLightSearch::depthFor(const Floor& floor) const {
  const int size = depths_.size, row = static_cast<int>(floor.submodule) / size;
  const int column = static_cast<int>(floor.submodule) % size;
  const double h = depths_.submoduleMm();
  const int right = towardsLamp_.x > 0 ? 1 : -1, down = towardsLamp_.y > 0 ? 1 : -1;
  const double perColumn = 1 / std::max(std::abs(towardsLamp_.x), 1e-9);
  const double perRow = 1 / std::max(std::abs(towardsLamp_.y), 1e-9);
  std::array<double, kSamples> needed{};
  for (int i = 0; i < kSamples; ++i) {
    const double x = (i + 0.5) / kSamples, y = (i * kSampleTurn % kSamples + 0.5) / kSamples;
    double nextColumn = (right > 0 ? 1 - x : x) * perColumn, nextRow = (down > 0 ? 1 - y : y) * perRow;
    int c = column, r = row;
    double least = std::numeric_limits<double>::infinity();
    for (;;) {
      const double travelled = std::min(nextColumn, nextRow);
      if (travelled * h * floor.tangent >= least) break;  // nothing rises above the surface
      if (nextColumn <= nextRow)
        c += right, nextColumn += perColumn;
      else
        r += down, nextRow += perRow;
      const bool isInside = c >= 0 && r >= 0 && c < size && r < size;
      const double depth = isInside ? depths_.depth(r, c) : 0;
      least = std::min(least, depth + travelled * h * floor.tangent);
    }
    needed[i] = least;
  }
  std::sort(needed.begin(), needed.end());
  return quantile(needed, std::min(floor.fraction, 1.0)) + std::max(floor.fraction - 1, 0.0) * h * floor.tangent;
}

void OneLightSearch::solve() {
  for (const Floor& floor : floors_) {
    const double limit = target_.limitMm[floor.submodule];
    depths_.depthMm[floor.submodule] = quantisedDepth(std::max(depthFor(floor), kDepthQuantumMm), limit);
  }
}

void OneLightSearch::update(const Grid<double>& luminance) {
  const Grid<double> modules = moduleMeans(luminance);
  const double open = openIrradiance(std::span(&options_.lamp, 1));
  bool moves = passes_ == 0;
  for (Floor& floor : floors_) {
    const double around = neighbours_.darkestMean(floor.module, modules);
    if (passes_ == 0) {
      takeElevation(floor, around * open - 1);
      continue;
    }
    const int row = static_cast<int>(floor.submodule) / depths_.size;
    const int column = static_cast<int>(floor.submodule) % depths_.size;
    if (luminanceOf(luminance, row, column) <= (1 - options_.contrast) * around) {
      floor.state = State::Done;
      continue;
    }
    const double limit = target_.limitMm[floor.submodule];
    const bool isAtLimit = depths_.depthMm[floor.submodule] >= quantisedDepth(limit, limit);
    floor.state = isAtLimit || floor.tangent == 0 ? State::Limited : State::TooBright;
    if (floor.state == State::Limited) continue;
    floor.fraction += kGrowth * std::min(floor.fraction, 1.0);
    moves = true;
  }
  ++passes_;
  finished_ = !moves || passes_ >= options_.maxPasses;
  if (!finished_) solve();
}

double OneLightSearch::doneFraction() const {
  const auto done = std::count_if(floors_.begin(), floors_.end(), [](const Floor& floor) {
    return floor.state == State::Done || floor.state == State::Limited;
  });
  return floors_.empty() ? 1 : static_cast<double>(done) / static_cast<double>(floors_.size());
}

std::size_t OneLightSearch::limitedCount() const {
  return static_cast<std::size_t>(std::count_if(floors_.begin(), floors_.end(),
                                                [](const Floor& floor) { return floor.state == State::Limited; })) +
         unfinishedCount();
}

std::size_t OneLightSearch::unfinishedCount() const {
  if (!finished_) return 0;
  return static_cast<std::size_t>(std::count_if(floors_.begin(), floors_.end(),
                                                [](const Floor& floor) { return floor.state == State::TooBright; }));
}

}  // namespace qrelief
