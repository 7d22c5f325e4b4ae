// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parallel.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace qrelief {
namespace {

TEST(ParallelFor, CallsEachIndexOnce) {
  std::vector<int> calls(1000, 0);
  parallelFor(calls.size(), [&](std::size_t i) { ++calls[i]; });
  EXPECT_EQ(calls, std::vector<int>(1000, 1));
}

TEST(ParallelFor, CallsNothingForAnEmptyRange) {
  parallelFor(0, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, RethrowsTheExceptionOfTheLowestIndexAndCallsNoIndexTwice) {
  std::vector<int> calls(100, 0);
  try {
    parallelFor(calls.size(), [&](std::size_t i) {
      ++calls[i];
      if (i % 30 == 17) throw std::runtime_error(std::to_string(i));
    });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "17");
  }
  EXPECT_EQ(std::accumulate(calls.begin(), calls.begin() + 18, 0), 18);
  EXPECT_EQ(*std::max_element(calls.begin(), calls.end()), 1);
}

}  // namespace
}  // namespace qrelief
