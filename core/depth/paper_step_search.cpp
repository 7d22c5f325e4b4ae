// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/paper_step_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "depth/light_neighbours.h"
#include "math/tolerance.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;

}  // namespace

double depthIncrease(int x) {
  constexpr double c0 = 0.1, d = 2, e = 3, f = 2.5;
  return c0 - c0 * e * (std::tanh(1 / d - f) + std::tanh(f - x / d));
}

PaperStepSearch::PaperStepSearch(CarvingTarget target, const DepthSearchOptions& options)
    : target_(std::move(target)), options_(options), neighbours_(*target_.symbol, options.surroundings) {
  const std::size_t count = target_.mask->size();
  assert(target_.limitMm.size() == count);
  depths_ = {target_.mask->rows(), target_.symbolMm, std::vector<double>(count, 0)};
  states_.assign(count, DepthState::Light);
  wantedMm_.assign(count, 0);
  previous_.assign(count, 0);
  unchanged_.assign(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (!(*target_.mask)[i]) continue;
    states_[i] = DepthState::Searching;
    wantedMm_[i] = depths_.depthMm[i] = quantisedDepth(options_.initialDepthMm, target_.limitMm[i]);
  }
}

void PaperStepSearch::update(const Grid<double>& luminance) {
  const int m = target_.symbol->size;
  const Grid<double> moduleLuminance = moduleMeans(luminance);

  bool deepened = false;
  worstExcess_ = 0;
  for (int module = 0; module < m * m; ++module) {
    const auto moduleIndex = static_cast<std::size_t>(module);
    if (!target_.symbol->dark[moduleIndex]) continue;
    const double threshold = neighbours_.darkestMean(moduleIndex, moduleLuminance) * (1 - options_.contrast);
    for (int k = 0; k < kN * kN; ++k) {
      const int row = module / m * kN + k / kN;
      const int column = module % m * kN + k % kN;
      const auto i = static_cast<std::size_t>(row * depths_.size + column);
      if (states_[i] == DepthState::Light) continue;
      const double now = luminanceOf(luminance, row, column);
      const bool isSame = iterations_ > 0 && std::abs(now - previous_[i]) < options_.significantChange;
      unchanged_[i] = isSame ? unchanged_[i] + 1 : 0;
      if (!isSame || options_.changeSince == ChangeSince::LastIteration) previous_[i] = now;
      const double excess = now - threshold;  // G
      worstExcess_ = std::max(worstExcess_, excess);
      if (excess <= 0) {
        states_[i] = DepthState::DarkEnough;
        continue;
      }
      wantedMm_[i] = (options_.roundSteps ? depths_.depthMm[i] : wantedMm_[i]) + depthIncrease(unchanged_[i]);
      const double deeper = quantisedDepth(wantedMm_[i], target_.limitMm[i]);
      states_[i] = deeper > depths_.depthMm[i] ? DepthState::Searching : DepthState::Limited;
      deepened = deepened || deeper > depths_.depthMm[i];
      depths_.depthMm[i] = std::max(deeper, depths_.depthMm[i]);
    }
  }
  ++iterations_;
  finished_ = !deepened || iterations_ >= options_.maxIterations;
}

double PaperStepSearch::doneFraction() const {
  std::size_t carved = 0, done = 0;
  for (const DepthState state : states_) {
    carved += state != DepthState::Light;
    done += state == DepthState::DarkEnough || state == DepthState::Limited;
  }
  return carved ? static_cast<double>(done) / static_cast<double>(carved) : 1;
}

std::size_t PaperStepSearch::limitedCount() const {
  return static_cast<std::size_t>(std::count(states_.begin(), states_.end(), DepthState::Limited)) + unfinishedCount();
}

std::size_t PaperStepSearch::unfinishedCount() const {
  return finished_ ? static_cast<std::size_t>(std::count(states_.begin(), states_.end(), DepthState::Searching)) : 0;
}

}  // namespace qrelief
