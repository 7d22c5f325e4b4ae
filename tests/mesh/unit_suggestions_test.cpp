// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/unit_suggestions.h"

#include <gtest/gtest.h>

#include "messages/sentences.h"

namespace qrelief {
namespace {

TEST(UnitSuggestions, NameMetresForAModelOfTwentyCentimetresInMetres) {
  const auto units = suggestUnits({0.2, 0.1, 0.15}, 1);
  ASSERT_EQ(units.size(), 1u);
  EXPECT_EQ(units[0], (UnitSuggestion{"m", 1000, {200, 100, 150}}));
}

TEST(UnitSuggestions, NameInchesAndCentimetresIfBothArePlausible) {
  const auto units = suggestUnits({5, 2.5, 1.5}, 1);
  ASSERT_EQ(units.size(), 2u);
  EXPECT_EQ(units[0].unit, "in");
  EXPECT_EQ(units[1], (UnitSuggestion{"cm", 10, {50, 25, 15}}));
  EXPECT_EQ(sentence(unitAdvice(units)),
            "If it should be larger, --units in makes it 127 × 63.5 × 38.1 mm, --units cm 50 × 25 × 15 mm; use --scale "
            "for any other scale");
}

TEST(UnitSuggestions, OmitTheUnitInUse) {
  const auto units = suggestUnits({7, 7, 7}, 10);  // 0.7 cm
  ASSERT_EQ(units.size(), 1u);
  EXPECT_EQ(units[0].unit, "in");
}

TEST(UnitSuggestions, AreNeverMoreThanTwo) {
  for (const double scale : {0.001, 1.0, 10.0, 25.4, 1000.0})
    for (double size = 1e-4; size < 1e6; size *= 1.1) EXPECT_LE(suggestUnits({size, size, size}, scale).size(), 2u);
}

TEST(UnitSuggestions, NameASmallerUnitForAHugeModel) {
  const auto um = suggestUnits({60'000, 20'000, 5000}, 1);
  ASSERT_EQ(um.size(), 1u);
  EXPECT_EQ(sentence(smallerUnitAdvice(um)),
            "If it should be smaller, --units um makes it 60 × 20 × 5 mm; use --scale for any other scale");
  const auto mm = suggestUnits({200'000, 80'000, 80'000}, 1000);
  ASSERT_EQ(mm.size(), 1u);
  EXPECT_EQ(mm[0], (UnitSuggestion{"mm", 1, {200, 80, 80}}));
  EXPECT_EQ(smallerUnitAdvice(suggestUnits({3000, 100, 100}, 1)).code, "unit-may-be-smaller");
}

TEST(UnitSuggestions, SuggestNoUnitIfNoneIsPlausible) {
  const auto units = suggestUnits({1e-3, 1e-3, 1e-3}, 1);
  EXPECT_TRUE(units.empty());
  EXPECT_EQ(unitAdvice(units).code, "unit-may-be-wrong");
}

}  // namespace
}  // namespace qrelief
