// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/value_map.h"

#include <gmock/gmock.h>
#include <limits>
#include <numeric>

#include "viewer/colour_scale.h"

namespace qrelief {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

TEST(ValueMap, ReturnsTheValueOfTheCellAndNothingOutside) {
  const ValueMap map{3, 2, {0, 1, 2, 3, 4, 5}, {}};
  EXPECT_EQ(map.indexAt({0, 0}), 0u);
  EXPECT_EQ(map.indexAt({0.34, 0.49}), 1u);
  EXPECT_EQ(map.indexAt({0.99, 0.51}), 5u);
  for (const Vec2 outside : {Vec2(-0.01, 0.5), Vec2(1, 0.5), Vec2(0.5, 1), Vec2(0.5, std::nan(""))})
    EXPECT_FALSE(map.indexAt(outside).has_value());
  EXPECT_FALSE(ValueMap{}.indexAt({0.5, 0.5}).has_value());
}

TEST(ValueRange, CoversOnlyFiniteNumbers) {
  const std::vector<float> values = {3, kNothing, -1, 7, std::numeric_limits<float>::infinity()};
  EXPECT_EQ(rangeOf(values), (ValueRange{-1, 7}));
  const std::vector<float> none = {kNothing};
  EXPECT_FALSE(rangeOf(none).has_value());
}

TEST(ValueRange, ACutDropsThatFractionAtEachEnd) {
  std::vector<float> values(101);
  std::iota(values.rbegin(), values.rend(), 0.0f);
  EXPECT_EQ(rangeOf(values, 0.1), (ValueRange{10, 90}));
}

TEST(Histogram, CountsEachNumberOnceAndClampsToTheEndBars) {
  const std::vector<float> values = {0, 0.24f, 0.25f, 0.5f, 1, 2, -1, kNothing};
  EXPECT_THAT(histogramOf(values, {0, 1}, 4), testing::ElementsAre(3, 1, 1, 2));
}

TEST(Histogram, PutsEqualValuesIntoOneBar) {
  const std::vector<float> values(5, 0.3f);
  EXPECT_THAT(histogramOf(values, {0.3f, 0.3f}, 3), testing::ElementsAre(5, 0, 0));
}

double lightnessOf(const Rgb8& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

TEST(ColourScale, GetsSteadilyLighterSoThatItNeedsNoHues) {
  for (const ColourScale scale : {ColourScale::Viridis, ColourScale::Cividis, ColourScale::Grey})
    for (int i = 1; i <= 100; ++i)
      EXPECT_GT(lightnessOf(colourAt(scale, i / 100.0)), lightnessOf(colourAt(scale, (i - 1) / 100.0)))
          << static_cast<int>(scale) << " at " << i;
}

TEST(ColourScale, IsPalestInTheMiddleForBothSigns) {
  for (int i = 1; i <= 50; ++i) {
    const double step = i / 100.0;
    EXPECT_LT(lightnessOf(colourAt(ColourScale::BlueRed, 0.5 - step)),
              lightnessOf(colourAt(ColourScale::BlueRed, 0.51 - step)));
    EXPECT_LT(lightnessOf(colourAt(ColourScale::BlueRed, 0.5 + step)),
              lightnessOf(colourAt(ColourScale::BlueRed, 0.49 + step)));
  }
}

TEST(ColourScale, ClampsToItsEndColours) {
  EXPECT_EQ(colourAt(ColourScale::Viridis, 0), (Rgb8{68, 1, 84}));
  EXPECT_EQ(colourAt(ColourScale::Viridis, 1), (Rgb8{253, 231, 37}));
  EXPECT_EQ(colourAt(ColourScale::Grey, -3), (Rgb8{0, 0, 0}));
  EXPECT_EQ(colourAt(ColourScale::Grey, 3), (Rgb8{255, 255, 255}));
  EXPECT_EQ(colourAt(ColourScale::Grey, 0.5), (Rgb8{128, 128, 128}));
}

TEST(MapPicture, ColoursNumbersByTheirRangeAndLeavesTheRestClear) {
  const ValueMap map{2, 2, {2, 4, kNothing, 9}, {}};
  EXPECT_THAT(colouredRgba(map, {ColourScale::Grey, {2, 6}, false}),
              testing::ElementsAre(0, 0, 0, 255, 128, 128, 128, 255, 0, 0, 0, 0, 255, 255, 255, 255));
}

TEST(MapPicture, ShowsDirectionsAsRedGreenAndBlueOnRequest) {
  const ValueMap map{2, 1, {90, 0}, {{1, 0, 0}, {0, 0, 1}}};
  EXPECT_THAT(colouredRgba(map, {ColourScale::Grey, {0, 90}, true}),
              testing::ElementsAre(255, 128, 128, 255, 128, 128, 255, 255));
  EXPECT_THAT(colouredRgba(map, {ColourScale::Grey, {0, 90}, false}),
              testing::ElementsAre(255, 255, 255, 255, 0, 0, 0, 255));
}

}  // namespace
}  // namespace qrelief
