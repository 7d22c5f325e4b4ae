// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "base/progress.h"

namespace qrelief {

/// Runs a job to its end. Expects a done fraction that never falls and is 1 only at the end.
/// @param job  has progress() and advance()
/// @returns the codes of its stages in their order; a stage that goes on counts once
template <class Job>
std::vector<std::string> followJob(Job& job) {
  std::vector<std::string> stages;
  double before = 0;
  const Status ended = advanceToEnd(job, [&](const Progress& progress) {
    if (stages.empty() || progress.stage.code != stages.back()) stages.push_back(progress.stage.code);
    EXPECT_GE(progress.fraction, before) << progress.stage.code;
    EXPECT_EQ(progress.fraction == 1, progress.done) << progress.stage.code;
    before = progress.fraction;
  });
  EXPECT_TRUE(ended.has_value()) << ended.error().message;
  EXPECT_EQ(before, 1);
  return stages;
}

}  // namespace qrelief
