// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/depth_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "math/tolerance.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr std::size_t kDarkestNeighbours = 4;

/// Depth on the grid of the files; a limit is never passed.
double quantised(double depthMm, double limitMm) {
  const double up = std::ceil(depthMm / kDepthQuantumMm - 1e-9) * kDepthQuantumMm;
  if (up <= limitMm) return up;
  return std::max(0.0, std::floor(limitMm / kDepthQuantumMm + 1e-9) * kDepthQuantumMm);
}

}  // namespace

double depthIncrease(int x) {
  constexpr double c0 = 0.1, d = 2, e = 3, f = 2.5;
  return c0 - c0 * e * (std::tanh(1 / d - f) + std::tanh(f - x / d));
}

DepthSearch::DepthSearch(CarvingTarget target, const DepthSearchOptions& options)
    : target_(std::move(target)), options_(options) {
  const std::size_t count = target_.mask->carved.size();
  assert(target_.limitMm.size() == count);
  depths_ = {target_.mask->size, target_.symbolMm, std::vector<double>(count, 0)};
  states_.assign(count, DepthState::Light);
  previous_.assign(count, 0);
  unchanged_.assign(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (!target_.mask->carved[i]) continue;
    states_[i] = DepthState::Searching;
    depths_.depthMm[i] = quantised(options_.initialDepthMm, target_.limitMm[i]);
  }
  findNeighbours();
}

void DepthSearch::findNeighbours() {
  const int m = target_.symbol->size;
  const int withQuiet = m + 2 * kQuietZoneModules;
  const auto isLight = [&](int row, int column) {
    return row < 0 || column < 0 || row >= m || column >= m || !target_.symbol->isDark(row, column);
  };
  neighbours_.resize(static_cast<std::size_t>(m * m));
  for (int row = 0; row < m; ++row) {
    for (int column = 0; column < m; ++column) {
      if (!target_.symbol->isDark(row, column)) continue;
      auto& found = neighbours_[static_cast<std::size_t>(row * m + column)];
      for (int ring = 1; found.size() < kDarkestNeighbours && ring < withQuiet; ++ring) {
        for (int r = row - ring; r <= row + ring; ++r) {
          for (int c = column - ring; c <= column + ring; ++c) {
            if (std::max(std::abs(r - row), std::abs(c - column)) != ring) continue;
            const int quietRow = r + kQuietZoneModules, quietColumn = c + kQuietZoneModules;
            if (quietRow < 0 || quietColumn < 0 || quietRow >= withQuiet || quietColumn >= withQuiet) continue;
            if (isLight(r, c)) found.push_back(static_cast<std::uint32_t>(quietRow * withQuiet + quietColumn));
          }
        }
      }
    }
  }
}

double DepthSearch::surroundings(std::size_t module, std::span<const double> moduleLuminance) const {
  std::vector<double> around;
  for (const std::uint32_t light : neighbours_[module]) around.push_back(moduleLuminance[light]);
  const std::size_t count = std::min(kDarkestNeighbours, around.size());
  std::partial_sort(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(count), around.end());
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += around[i];
  return sum / static_cast<double>(count);
}

void DepthSearch::update(std::span<const double> luminance) {
  const int m = target_.symbol->size;
  const int withQuiet = m + 2 * kQuietZoneModules;
  const int edge = kN * withQuiet;
  assert(luminance.size() == static_cast<std::size_t>(edge * edge));

  std::vector<double> moduleLuminance(static_cast<std::size_t>(withQuiet * withQuiet), 0);
  for (int row = 0; row < edge; ++row)
    for (int column = 0; column < edge; ++column)
      moduleLuminance[static_cast<std::size_t>(row / kN * withQuiet + column / kN)] +=
          luminance[static_cast<std::size_t>(row * edge + column)] / (kN * kN);

  bool deepened = false;
  worstExcess_ = 0;
  for (int module = 0; module < m * m; ++module) {
    const auto moduleIndex = static_cast<std::size_t>(module);
    if (neighbours_[moduleIndex].empty()) continue;
    const double threshold = surroundings(moduleIndex, moduleLuminance) * (1 - options_.contrast);
    for (int k = 0; k < kN * kN; ++k) {
      const int row = module / m * kN + k / kN;
      const int column = module % m * kN + k % kN;
      const auto i = static_cast<std::size_t>(row * depths_.size + column);
      if (states_[i] == DepthState::Light) continue;
      const double now =
          luminance[static_cast<std::size_t>((row + kN * kQuietZoneModules) * edge + column + kN * kQuietZoneModules)];
      unchanged_[i] =
          iterations_ > 0 && std::abs(now - previous_[i]) < options_.significantChange ? unchanged_[i] + 1 : 0;
      previous_[i] = now;
      const double excess = now - threshold;  // G
      worstExcess_ = std::max(worstExcess_, excess);
      if (excess <= 0) {
        states_[i] = DepthState::DarkEnough;
        continue;
      }
      const double deeper = quantised(depths_.depthMm[i] + depthIncrease(unchanged_[i]), target_.limitMm[i]);
      states_[i] = deeper > depths_.depthMm[i] ? DepthState::Searching : DepthState::Limited;
      deepened = deepened || deeper > depths_.depthMm[i];
      depths_.depthMm[i] = std::max(deeper, depths_.depthMm[i]);
    }
  }
  ++iterations_;
  finished_ = !deepened || iterations_ >= options_.maxIterations;
}

double DepthSearch::doneShare() const {
  std::size_t carved = 0, done = 0;
  for (const DepthState state : states_) {
    carved += state != DepthState::Light;
    done += state == DepthState::DarkEnough || state == DepthState::Limited;
  }
  return carved ? static_cast<double>(done) / static_cast<double>(carved) : 1;
}

std::size_t DepthSearch::limitedCount() const {
  return static_cast<std::size_t>(std::count(states_.begin(), states_.end(), DepthState::Limited));
}

}  // namespace qrelief
