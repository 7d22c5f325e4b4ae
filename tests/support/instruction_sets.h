// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace qrelief {

/// Computes a result with each instruction set of this machine and expects the same bits. WebAssembly has one
/// instruction set and no choice at run time, so the test is skipped there.
/// @param compute  returns a value with operator==
template <class Compute>
void expectSameByAllInstructionSets([[maybe_unused]] const Compute& compute) {
#ifdef __EMSCRIPTEN__
  GTEST_SKIP() << "WebAssembly has one instruction set";
#else
  const auto all = hwy::SupportedAndGeneratedTargets();
  ASSERT_GT(all.size(), 1u);
  const auto by = [&](auto target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().DeInit();  // the next call chooses again
    return compute();
  };
  const auto first = by(all.front());
  for (const auto target : all) EXPECT_TRUE(by(target) == first) << hwy::TargetName(target);
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
#endif
}

}  // namespace qrelief
