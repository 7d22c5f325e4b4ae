// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/fast_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/parallel.h"
#include "depth/light_neighbours.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr std::size_t kFloorsAPiece = 512;  // of parallel work

/// log((1 − V)/V)
double darkness(double fraction) {
  const double v = std::clamp(fraction, 1e-3, 1 - 1e-3);
  return std::log((1 - v) / v);
}

double fractionOfDarkness(double darkness) { return 1 / (1 + std::exp(darkness)); }

}  // namespace

void DepthBounds::measured(double depthMm, double fraction, double asked) {
  if (fraction <= asked) {
    darkMm = depthMm;
    darkFraction = fraction;
    return;
  }
  brightMm = depthMm;
  brightFraction = fraction;
  if (darkMm <= brightMm) darkMm = 0;
}

double DepthBounds::neededMm(double asked) const {
  assert(isClosed());
  if (brightFraction <= asked || darkFraction >= asked) return darkMm;
  return brightMm + (darkMm - brightMm) * (brightFraction - asked) / (brightFraction - darkFraction);
}

double DepthBounds::nextMm(double asked) const {
  const double width = darkMm - brightMm;
  if (width < 2.5 * kDepthQuantumMm) return darkMm;
  // The edge of a shadow darkens a floor in a small part of a step: then the line is far off, and halves are safer.
  return std::clamp(neededMm(asked), brightMm + width / 4, darkMm - width / 4);
}

FastSearch::FastSearch(CarvingTarget target, const FastSearchOptions& options, const FastSearch* before)
    : target_(std::move(target)),
      options_(options),
      neighbours_(*target_.symbol),
      sky_(before ? before->sky_
                  : std::make_shared<const PocketSky>(*target_.mask, target_.symbolMm / target_.mask->rows())),
      freePasses_(options_.hasLamps ? 0
                  : before          ? kFreePassesAfterAnother
                                    : kFreePasses) {
  depths_ = {target_.mask->rows(), target_.symbolMm, std::vector<double>(target_.mask->size(), 0)};
  const std::size_t count = sky_->carved().size();
  for (std::size_t k = 0; k < count; ++k) {
    limitMm_.push_back(target_.limitMm[sky_->carved()[k]]);
    fractionAsked_.push_back(
        1 - (options_.contrastOfModule.empty() ? options_.contrast : options_.contrastOfModule[moduleOf(k)]));
  }
  solvedMm_.assign(count, kFirstDepthModules * target_.symbolMm / target_.symbol->size);
  difference_.assign(count, firstDifference(static_cast<double>(options_.albedo)));
  differenceChange_.assign(count, 0);
  seenFraction_.assign(count, 1);
  states_.assign(count, State::TooBright);
  isDue_.assign(count, 1);
  isStale_.assign(count, 1);
  bounds_.resize(count);
  if (before) {
    assert(before->difference_.size() == count);
    solvedMm_ = before->solvedMm_;
    difference_ = before->difference_;
    bounds_ = before->bounds_;
    for (DepthBounds& bounds : bounds_) bounds.returns = 0;
  }
  if (before && options_.hasLamps)
    depths_ = before->depths_;
  else
    solve();
}

void FastSearch::solve() {
  const double lastAim = aimForTooBright(iterations_, freePasses_);
  std::vector<double> fractions;
  for (std::size_t k = 0; k < states_.size(); ++k) {
    const double margin = states_[k] == State::TooBright ? lastAim : kAimFraction;
    const double allowance = kChangeFraction * std::min(differenceChange_[k], kMaxChange);
    fractions.push_back(fractionOfDarkness(darkness(fractionAsked_[k] * (1 - margin)) + allowance - difference_[k]));
  }
  sky_->solve(fractions, limitMm_, solvedMm_, isDue_, options_.sweepsPerPass);
  const PocketSky::Depths solved(*sky_, solvedMm_);
  parallelForPieces(states_.size(), kFloorsAPiece, [&](std::size_t k) {
    double& depth = depths_.depthMm[sky_->carved()[k]];
    const double most = options_.hasLamps ? depth + std::max(kLampStepMm, kLampGrowth * depth) : limitMm_[k];
    const double next = quantisedDepth(std::clamp(solvedMm_[k], kDepthQuantumMm, most), limitMm_[k]);
    const bool isFree = iterations_ < freePasses_;
    if (options_.hasLamps && bounds_[k].isClosed() && states_[k] != State::Done && states_[k] != State::Limited)
      depth =
          quantisedDepth(mayReturn(iterations_) ? bounds_[k].nextMm(aimedFraction(k)) : bounds_[k].darkMm, limitMm_[k]);
    else if (!isFree && states_[k] == State::TooBright)
      depth = quantisedDepth(std::max(next, depth + leastGrowthMm(options_, iterations_)), limitMm_[k]);
    else if (isFree || (next > depth && expectedFraction(k, solved.fraction(k, depth)) > fractionAsked_[k]))
      depth = next;
  });
}

/// Returns true if a floor that is dark enough at a depth should go back.
bool FastSearch::isTooDeepUnderLamps(std::size_t k, double depthMm) const {
  return mayReturn(iterations_ + 1) && bounds_[k].isClosed() && bounds_[k].returns < kLampReturns &&
         depthMm - bounds_[k].neededMm(aimedFraction(k)) > kLampSlackMm;
}

/// Returns the expected LS/AL of a floor: the plane's prediction corrected by the measured difference.
double FastSearch::expectedFraction(std::size_t k, double planeFraction) const {
  return fractionOfDarkness(darkness(planeFraction) + difference_[k]);
}

/// Returns the index of a floor's module.
std::size_t FastSearch::moduleOf(std::size_t k) const {
  const std::size_t i = sky_->carved()[k], size = static_cast<std::size_t>(depths_.size);
  return i / size / kN * static_cast<std::size_t>(target_.symbol->size) + i % size / kN;
}

/// Returns the depths in the order of sky_->carved().
std::vector<double> FastSearch::carvedDepths() const {
  std::vector<double> depths;
  for (const std::uint32_t i : sky_->carved()) depths.push_back(depths_.depthMm[i]);
  return depths;
}

/// Chooses the floors to measure: floors that moved or touch one that moved, and floors that may now be too bright if
/// the change since their last measurement is twice what the plane predicts. While all floors may still move, chooses
/// all.
void FastSearch::chooseDue(const std::vector<double>& depthsBefore) {
  dueInMask_.clear();
  if (iterations_ < freePasses_) return;
  const std::vector<double> depths = carvedDepths();
  const PocketSky::Depths onPlane(*sky_, depths);
  const auto moved = [&](int row, int column) {
    if (row < 0 || column < 0 || row >= depths_.size || column >= depths_.size) return false;
    const auto i = static_cast<std::size_t>(row * depths_.size + column);
    return depths_.depthMm[i] != depthsBefore[i];
  };
  parallelForPieces(isDue_.size(), kFloorsAPiece, [&](std::size_t k) {
    const std::uint32_t i = sky_->carved()[k];
    const int row = static_cast<int>(i) / depths_.size, column = static_cast<int>(i) % depths_.size;
    bool due = false;
    for (int near = 0; near < 9; ++near) due = due || moved(row - 1 + near / 3, column - 1 + near % 3);
    if (!due && states_[k] == State::Done) {
      const double expected = expectedFraction(k, onPlane.fraction(k, depths[k]));
      due = expected + (expected - seenFraction_[k]) > fractionAsked_[k];
    }
    isDue_[k] = due;
  });
  for (std::size_t k = 0; k < isDue_.size(); ++k)
    if (isDue_[k]) dueInMask_.push_back(sky_->carved()[k]);
}

void FastSearch::update(const Grid<double>& luminance) {
  const auto m = static_cast<std::size_t>(target_.symbol->size);
  const Grid<double> modules = moduleMeans(luminance);
  const std::vector<double> depths = carvedDepths();
  const PocketSky::Depths onPlane(*sky_, depths);
  std::vector<double> around(m * m, 0.0);  // of the modules with due floors
  for (std::size_t k = 0; k < states_.size(); ++k)
    if (const std::size_t module = moduleOf(k); isDue_[k] && around[module] == 0)
      around[module] = neighbours_.darkestMean(module, modules);
  parallelForPieces(states_.size(), kFloorsAPiece, [&](std::size_t k) {
    if (!isDue_[k]) return;
    isStale_[k] = 0;
    const int row = static_cast<int>(sky_->carved()[k]) / depths_.size;
    const int column = static_cast<int>(sky_->carved()[k]) % depths_.size;
    const double fraction = luminanceOf(luminance, row, column) / around[moduleOf(k)];
    seenFraction_[k] = fraction;
    const double difference = darkness(fraction) - darkness(onPlane.fraction(k, depths[k]));
    if (iterations_ > 0) differenceChange_[k] = std::abs(difference - difference_[k]);
    difference_[k] = difference;
    if (options_.hasLamps) bounds_[k].measured(depths[k], fraction, fractionAsked_[k]);
    if (fraction > fractionAsked_[k]) {
      states_[k] =
          quantisedDepth(depths[k] + kDepthQuantumMm, limitMm_[k]) > depths[k] ? State::TooBright : State::Limited;
    } else {
      const double aim = darkness(fractionAsked_[k] * (1 - kAimFraction));
      const double less = std::max(depths[k] - options_.slackMm, 0.0);
      const bool couldBeLess = options_.hasLamps ? isTooDeepUnderLamps(k, depths[k])
                                                 : iterations_ + 1 < freePasses_ && less > 0 &&
                                                       darkness(onPlane.fraction(k, less)) + difference_[k] > aim;
      states_[k] = couldBeLess ? State::TooDeep : State::Done;
      if (couldBeLess) ++bounds_[k].returns;
    }
  });
  ++iterations_;
  const bool allDone = std::all_of(states_.begin(), states_.end(),
                                   [](State state) { return state == State::Done || state == State::Limited; });
  if (allAreDue() && (allDone || iterations_ > freePasses_)) allRemeasured_ = true;
  finished_ = iterations_ >= options_.maxIterations;
  if (finished_) return;
  if (allDone) {
    chooseStale();
    return;
  }
  const std::vector<double> depthsBefore = depths_.depthMm;
  solve();
  markStale(depthsBefore);
  chooseDue(depthsBefore);
}

/// Chooses the floors to measure before the search may end; ends it if there are none.
void FastSearch::chooseStale() {
  if (!allRemeasured_) isStale_.assign(isStale_.size(), 1);
  isDue_ = isStale_;
  dueInMask_.clear();
  for (std::size_t k = 0; k < isDue_.size(); ++k)
    if (isDue_[k]) dueInMask_.push_back(sky_->carved()[k]);
  finished_ = dueInMask_.empty();
  if (dueInMask_.size() == isDue_.size()) dueInMask_.clear();
}

void FastSearch::markStale(const std::vector<double>& depthsBefore) {
  for (std::size_t k = 0; k < isStale_.size(); ++k) {
    if (depths_.depthMm[sky_->carved()[k]] == depthsBefore[sky_->carved()[k]]) continue;
    isStale_[k] = 1;
    sky_->forEachInSight(k, [&](std::uint32_t other) { isStale_[other] = 1; });
  }
}

double FastSearch::doneFraction() const {
  const auto done = std::count_if(states_.begin(), states_.end(),
                                  [](State state) { return state == State::Done || state == State::Limited; });
  return states_.empty() ? 1 : static_cast<double>(done) / static_cast<double>(states_.size());
}

std::size_t FastSearch::limitedCount() const {
  return static_cast<std::size_t>(std::count(states_.begin(), states_.end(), State::Limited)) + unfinishedCount();
}

std::size_t FastSearch::unfinishedCount() const {
  return finished_ ? static_cast<std::size_t>(std::count(states_.begin(), states_.end(), State::TooBright)) : 0;
}

}  // namespace qrelief
