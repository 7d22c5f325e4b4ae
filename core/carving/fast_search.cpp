// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/fast_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carving/submodule_luminances.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr double kFirstDepthModules = 0.25;
constexpr double kAimShare = 0.003;  // of the threshold: so much darker is aimed at, so that G ends at 0 or below
constexpr double kGreatestAimShare = 0.2;
constexpr double kSurpriseShare = 0.4;     // of the last surprise: so much more darkness is aimed at
constexpr double kGreatestSurprise = 0.3;  // that counts
constexpr int kSweepsPerPass = 3;
constexpr int kFreePasses = 3;  // after these nothing becomes less deep: that ends
constexpr double kGreatestAlbedo = 0.95;

/// log((1 − V)/V)
double darkness(double share) {
  const double v = std::clamp(share, 1e-3, 1 - 1e-3);
  return std::log((1 - v) / v);
}

double shareOfDarkness(double darkness) { return 1 / (1 + std::exp(darkness)); }

}  // namespace

FastSearch::FastSearch(CarvingTarget target, const FastSearchOptions& options)
    : target_(std::move(target)),
      options_(options),
      neighbours_(*target_.symbol),
      sky_(*target_.mask, target_.symbolMm / target_.mask->size) {
  depths_ = {target_.mask->size, target_.symbolMm, std::vector<double>(target_.mask->carved.size(), 0)};
  for (const std::uint32_t i : sky_.carved()) limitMm_.push_back(target_.limitMm[i]);
  const std::size_t count = sky_.carved().size();
  solvedMm_.assign(count, kFirstDepthModules * target_.symbolMm / target_.symbol->size);
  difference_.assign(count, std::log(1 - std::min(options_.albedo, kGreatestAlbedo)));
  surprise_.assign(count, 0);
  seenShare_.assign(count, 1);
  states_.assign(count, State::TooBright);
  isDue_.assign(count, 1);
  isOld_.assign(count, 1);
  solve();
}

void FastSearch::solve() {
  // The few that stay too bright are those that the plane says too little of.
  const double lastAim =
      std::min(kAimShare * std::pow(3.0, std::max(0, iterations_ - kFreePasses + 1)), kGreatestAimShare);
  std::vector<double> shares;
  for (std::size_t k = 0; k < states_.size(); ++k) {
    const double margin = states_[k] == State::TooBright ? lastAim : kAimShare;
    const double unsure = kSurpriseShare * std::min(surprise_[k], kGreatestSurprise);
    shares.push_back(shareOfDarkness(darkness((1 - options_.contrast) * (1 - margin)) + unsure - difference_[k]));
  }
  sky_.solve(shares, limitMm_, solvedMm_, isDue_, kSweepsPerPass);
  for (std::size_t k = 0; k < states_.size(); ++k) {
    double& depth = depths_.depthMm[sky_.carved()[k]];
    const double next = quantisedDepth(std::max(solvedMm_[k], kDepthQuantumMm), limitMm_[k]);
    if (iterations_ < kFreePasses)
      depth = next;
    else if (states_[k] == State::TooBright)
      depth = quantisedDepth(std::max(next, depth + kDepthQuantumMm), limitMm_[k]);
    else if (next > depth && expectedShare(k, depth, solvedMm_) > 1 - options_.contrast)
      depth = next;
  }
}

/// LS/AL of a floor by what the plane says and what was seen to differ from it.
double FastSearch::expectedShare(std::size_t k, double depthMm, std::span<const double> depthsMm) const {
  return shareOfDarkness(darkness(sky_.share(k, depthMm, depthsMm)) + difference_[k]);
}

/// What has moved or touches what has, and what may be too bright for it, were the change since it was seen twice what
/// the plane says; while all may still move, all.
void FastSearch::chooseDue(const std::vector<double>& depthsBefore) {
  dueInMask_.clear();
  if (iterations_ < kFreePasses) return;
  std::vector<double> depths;
  for (const std::uint32_t i : sky_.carved()) depths.push_back(depths_.depthMm[i]);
  const auto moved = [&](int row, int column) {
    if (row < 0 || column < 0 || row >= depths_.size || column >= depths_.size) return false;
    const auto i = static_cast<std::size_t>(row * depths_.size + column);
    return depths_.depthMm[i] != depthsBefore[i];
  };
  for (std::size_t k = 0; k < isDue_.size(); ++k) {
    const std::uint32_t i = sky_.carved()[k];
    const int row = static_cast<int>(i) / depths_.size, column = static_cast<int>(i) % depths_.size;
    bool due = false;
    for (int near = 0; near < 9; ++near) due = due || moved(row - 1 + near / 3, column - 1 + near % 3);
    if (!due && states_[k] == State::Done) {
      const double expected = expectedShare(k, depths[k], depths);
      due = expected + (expected - seenShare_[k]) > 1 - options_.contrast;
    }
    isDue_[k] = due;
    if (due) dueInMask_.push_back(i);
  }
}

void FastSearch::update(std::span<const double> luminance) {
  const int m = target_.symbol->size;
  const SubmoduleLuminances seen(luminance, m);
  const std::vector<double> modules = seen.moduleMeans();
  std::vector<double> depths;
  for (const std::uint32_t i : sky_.carved()) depths.push_back(depths_.depthMm[i]);

  const double aim = darkness((1 - options_.contrast) * (1 - kAimShare));
  std::size_t module = std::numeric_limits<std::size_t>::max();
  double around = 1;
  for (std::size_t k = 0; k < states_.size(); ++k) {
    if (!isDue_[k]) continue;
    isOld_[k] = 0;
    const int row = static_cast<int>(sky_.carved()[k]) / depths_.size;
    const int column = static_cast<int>(sky_.carved()[k]) % depths_.size;
    const auto of = static_cast<std::size_t>(row / kN * m + column / kN);
    if (of != module) around = neighbours_.darkestMean(of, modules);
    module = of;
    const double share = seen.of(row, column) / around;
    seenShare_[k] = share;
    const double difference = darkness(share) - darkness(sky_.share(k, depths[k], depths));
    if (iterations_ > 0) surprise_[k] = std::abs(difference - difference_[k]);
    difference_[k] = difference;
    if (share > 1 - options_.contrast) {
      states_[k] =
          quantisedDepth(depths[k] + kDepthQuantumMm, limitMm_[k]) > depths[k] ? State::TooBright : State::Limited;
    } else {
      const double less = std::max(depths[k] - options_.slackMm, 0.0);
      const bool couldBeLess =
          iterations_ + 1 < kFreePasses && less > 0 && darkness(sky_.share(k, less, depths)) + difference_[k] > aim;
      states_[k] = couldBeLess ? State::TooDeep : State::Done;
    }
  }
  ++iterations_;
  const bool allDone = std::all_of(states_.begin(), states_.end(),
                                   [](State state) { return state == State::Done || state == State::Limited; });
  if (allAreDue() && (allDone || iterations_ > kFreePasses)) allSeenOnceMore_ = true;
  finished_ = iterations_ >= options_.maxIterations;
  if (finished_) return;
  if (allDone) {
    lookAgain();
    return;
  }
  const std::vector<double> depthsBefore = depths_.depthMm;
  solve();
  makeOld(depthsBefore);
  chooseDue(depthsBefore);
}

/// Chooses what is to be measured before the search may end; ends it if that is nothing.
void FastSearch::lookAgain() {
  if (!allSeenOnceMore_) isOld_.assign(isOld_.size(), 1);
  isDue_ = isOld_;
  dueInMask_.clear();
  for (std::size_t k = 0; k < isDue_.size(); ++k)
    if (isDue_[k]) dueInMask_.push_back(sky_.carved()[k]);
  finished_ = dueInMask_.empty();
  if (dueInMask_.size() == isDue_.size()) dueInMask_.clear();
}

void FastSearch::makeOld(const std::vector<double>& depthsBefore) {
  for (std::size_t k = 0; k < isOld_.size(); ++k) {
    if (depths_.depthMm[sky_.carved()[k]] == depthsBefore[sky_.carved()[k]]) continue;
    isOld_[k] = 1;
    for (const std::uint32_t other : sky_.seenFrom(k)) isOld_[other] = 1;
  }
}

double FastSearch::doneShare() const {
  const auto done = std::count_if(states_.begin(), states_.end(),
                                  [](State state) { return state == State::Done || state == State::Limited; });
  return states_.empty() ? 1 : static_cast<double>(done) / static_cast<double>(states_.size());
}

std::size_t FastSearch::limitedCount() const {
  return static_cast<std::size_t>(std::count(states_.begin(), states_.end(), State::Limited));
}

}  // namespace qrelief
