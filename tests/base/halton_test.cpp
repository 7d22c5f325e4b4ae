// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/halton.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

TEST(Halton, GivesTheFirstTenPointsOfTheLiterature) {
  const double base2[] = {1. / 2, 1. / 4, 3. / 4, 1. / 8, 5. / 8, 3. / 8, 7. / 8, 1. / 16, 9. / 16, 5. / 16};
  const double base3[] = {1. / 3, 2. / 3, 1. / 9, 4. / 9, 7. / 9, 2. / 9, 5. / 9, 8. / 9, 1. / 27, 10. / 27};
  for (std::uint32_t k = 0; k < 10; ++k) {
    EXPECT_EQ(halton23(k + 1)[0], base2[k]) << "point " << k + 1;
    EXPECT_EQ(halton23(k + 1)[1], base3[k]) << "point " << k + 1;
  }
}

TEST(Halton, StartsAtTheCorner) { EXPECT_EQ(halton23(0), (std::array<double, 2>{0, 0})); }

TEST(Halton, PutsOnePointIntoEachBoxOfAnElementaryPartition) {
  // 2^3 · 3^2 consecutive points: exactly one falls into each of 8 × 9 boxes.
  int boxes[8][9] = {};
  for (std::uint32_t k = 72; k < 144; ++k) {
    const std::array<double, 2> p = halton23(k);
    // Denominators are powers of 3, so p·9 falls short of a whole number only by rounding.
    ++boxes[static_cast<int>(p[0] * 8)][static_cast<int>(p[1] * 9 + 1e-9)];
  }
  for (const auto& column : boxes)
    for (const int count : column) EXPECT_EQ(count, 1);
}

TEST(Halton, StaysBelowOneForTheLargestIndex) {
  EXPECT_LT(radicalInverse(0xffffffffu, 2), 1);
  EXPECT_EQ(radicalInverse(0xffffffffu, 2), 1 - 0x1p-32);
  EXPECT_LT(radicalInverse(0xffffffffu, 3), 1);
}

}  // namespace
}  // namespace qrelief
