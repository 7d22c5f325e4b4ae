// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/view_trials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

/// @param reads  returns true if a trial succeeds
template <class Reads>
ViewTrials tried(const Reads& reads) {
  ViewTrials trials(8);
  while (!trials.done()) trials.note(reads(trials.due()));
  return trials;
}

TEST(ViewTrials, EverythingReads) {
  const ViewTrials trials = tried([](const ViewTrial&) { return true; });
  const ViewTrialSummary summary = trials.summary();
  EXPECT_EQ(summary.tilts.size(), kTiltsDeg.size());
  EXPECT_EQ(summary.safeTiltDeg, 45);
  EXPECT_EQ(summary.pixelsPerModule, 2.0);
  EXPECT_EQ(trials.tried(), trials.all());
  EXPECT_EQ(trials.all(), 20u + 6u);  // plus the distances with fewer than 8 pixels
}

TEST(ViewTrials, IsSafeUpToTheLastTiltBeforeTheFirstFailure) {
  const auto summary =
      tried([](const ViewTrial& trial) { return trial.tiltDeg < 15 || trial.azimuthDeg > 0; }).summary();
  EXPECT_EQ(summary.safeTiltDeg, 10);
  ASSERT_EQ(summary.tilts.size(), 5u);
  EXPECT_EQ(summary.tilts[2].reads, 3);
  EXPECT_EQ(summary.tilts[2].all, 4);
}

TEST(ViewTrials, StopsTiltingOnceNothingDecodes) {
  int asked = 0;
  const auto summary = tried([&](const ViewTrial& trial) {
                         asked += trial.tiltDeg > 0;
                         return trial.tiltDeg < 10;
                       }).summary();
  EXPECT_EQ(asked, 8);  // 5 and 10 degrees, four sides each
  EXPECT_EQ(summary.tilts.size(), 2u);
  EXPECT_EQ(summary.safeTiltDeg, 5);
}

TEST(ViewTrials, TheDistanceEndsAtTheFirstFailure) {
  const auto summary = tried([](const ViewTrial& trial) { return trial.pixelsPerModule.value_or(9) != 3.3; }).summary();
  EXPECT_EQ(summary.pixelsPerModule, 4.0);
  EXPECT_EQ(tried([](const ViewTrial&) { return false; }).summary().pixelsPerModule, std::nullopt);
}

TEST(VideoDistance, PhoneVideoHasThreePixelsPerMillimetreFromHalfAMetre) {
  EXPECT_NEAR(videoDistanceMm(1, 3), 502.3, 0.1);  // 960 / tan 32.5° / 3
  EXPECT_NEAR(videoDistanceMm(2, 3), 2 * videoDistanceMm(1, 3), 1e-9);
}

}  // namespace
}  // namespace qrelief
