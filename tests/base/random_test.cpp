// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/random.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

TEST(Random, GivesThePublishedSequenceOfSplitMix64) {
  Random random(1234567);
  for (const std::uint64_t expected :
       {6457827717110365317u, 3203168211198807973u, 9817491932198370423u, 4593380528125082431u, 16408922859458223821u})
    EXPECT_EQ(random.next(), expected);
}

TEST(Random, MapsTheTopBitsOfANumberToTheUnitInterval) {
  Random bits(42);
  Random reals(42);
  for (int k = 0; k < 1000; ++k) {
    const double value = reals.uniform();
    EXPECT_EQ(value, static_cast<double>(bits.next() >> 11) / 9007199254740992.0);
    EXPECT_LT(value, 1);
  }
}

TEST(Random, StaysWithinTheGivenLimits) {
  Random random(1);
  for (int k = 0; k < 1000; ++k) {
    const double value = random.uniform(-3, 5);
    EXPECT_GE(value, -3);
    EXPECT_LT(value, 5);
  }
}

TEST(Random, DrawsEachIntegerEquallyOften) {
  Random random(2);
  std::array<int, 7> counts{};
  for (int k = 0; k < 70000; ++k) ++counts[static_cast<std::size_t>(random.below(7))];
  // The standard deviation is √(70000·6/49) = 93.
  for (const int count : counts) EXPECT_NEAR(count, 10000, 5 * 93);
}

TEST(Random, DrawsNormalNumbersOfMeanZeroAndDeviationOne) {
  Random random(4);
  constexpr int kCount = 40000;
  double sum = 0, squares = 0, within = 0;
  for (int k = 0; k < kCount; ++k) {
    const double value = random.normal();
    sum += value;
    squares += value * value;
    within += std::abs(value) < 1;
  }
  EXPECT_NEAR(sum / kCount, 0, 5.0 / std::sqrt(kCount));
  EXPECT_NEAR(squares / kCount, 1, 5 * std::sqrt(2.0 / kCount));
  EXPECT_NEAR(within / kCount, 0.683, 0.015);
}

TEST(Random, HasNoChoiceBelowOne) {
  Random random(3);
  EXPECT_EQ(random.below(1), 0u);
}

}  // namespace
}  // namespace qrelief
