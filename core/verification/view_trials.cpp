// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/view_trials.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "math/angle.h"

namespace qrelief {

double videoDistanceMm(double moduleMm, double pixelsPerModule) {
  constexpr double kVideoPixels = 1920, kVideoDeg = 65;
  return kVideoPixels / 2 / std::tan(toRadians(kVideoDeg / 2)) * moduleMm / pixelsPerModule;
}

ViewTrials::ViewTrials(double pixelsPerModule) {
  for (const double tiltDeg : kTiltsDeg)
    for (const double azimuthDeg : kAzimuthsDeg) trials_.push_back({tiltDeg, azimuthDeg});
  for (const double pixels : kDistancesPx)
    if (pixels < pixelsPerModule) trials_.push_back({.pixelsPerModule = pixels});
  leftOut_.assign(trials_.size(), false);
}

void ViewTrials::note(bool read) {
  assert(!done());
  const double tiltDeg = trials_[next_].tiltDeg;
  read_.push_back(read);
  ++next_;
  if (done() || tiltDeg == 0 || trials_[next_].tiltDeg == tiltDeg) return;
  const bool anyRead = std::any_of(read_.end() - static_cast<std::ptrdiff_t>(kAzimuthsDeg.size()), read_.end(),
                                   [](bool one) { return one; });
  for (; !anyRead && !done() && trials_[next_].tiltDeg > 0; ++next_) {  // larger tilts cannot decode, either
    leftOut_[next_] = true;
    read_.push_back(false);
  }
}

ViewTrialSummary ViewTrials::summary() const {
  ViewTrialSummary summary;
  bool isSafe = true, hasGap = false;
  for (std::size_t i = 0; i < next_; ++i) {
    const ViewTrial& trial = trials_[i];
    if (leftOut_[i]) continue;
    if (trial.pixelsPerModule) {
      hasGap |= !read_[i];
      if (!hasGap) summary.pixelsPerModule = trial.pixelsPerModule;
      continue;
    }
    if (summary.tilts.empty() || summary.tilts.back().tiltDeg != trial.tiltDeg)
      summary.tilts.push_back({trial.tiltDeg, 0, 0});
    ++summary.tilts.back().all;
    summary.tilts.back().reads += read_[i];
  }
  for (const ViewTrialSummary::Tilt& tilt : summary.tilts) {
    isSafe &= tilt.reads == tilt.all;
    if (isSafe) summary.safeTiltDeg = tilt.tiltDeg;
  }
  return summary;
}

}  // namespace qrelief
