// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/print_decal.h"

#include <cmath>
#include <gtest/gtest.h>

#include "io/write_stl.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr int kSize = 330;  // ten pixels a module: 21 modules and 6 on either side

class PrintDecalTest : public testing::Test {
 protected:
  void SetUp() override {
    auto model = loadedModel(nullptr, writeStl(shapes::box({60, 60, 20})), "box.stl", 1);
    ASSERT_TRUE(model);
    model_ = std::move(*model);
    placement_.frame = makeFrame({0, 0, 10}, {0, 0, 1}, {0, 1, 0}, 250);
    placement_.symbolMm = 21;
    placement_.moduleMm = 1;
  }
  int ink(const Decal& decal, int row, int column) const {
    return decal.ink[static_cast<std::size_t>(row * kSize + column)];
  }

  LoadedModel model_;
  Placement placement_;
};

TEST_F(PrintDecalTest, LightModulesAreTheSurfaceAndDarkOnesInk) {
  std::vector<std::uint8_t> pixels(kSize * kSize, 200);
  for (int row = 60; row < 70; ++row)
    for (int column = 60; column < 70; ++column) pixels[static_cast<std::size_t>(row * kSize + column)] = 50;
  pixels[100 * kSize + 100] = 240;  // lighter than the surface
  const auto decal = printDecal(model_, placement_, pixels, kSize, false);
  ASSERT_TRUE(decal);
  EXPECT_TRUE(decal->isInkOnly);
  EXPECT_DOUBLE_EQ(decal->edgeMm, 33);
  EXPECT_EQ(decal->size, kSize);
  // Greys of 50 and 200 are 0.032 and 0.578 of the light of white.
  EXPECT_NEAR(ink(*decal, 65, 65), 255 * (1 - 0.0319 / 0.5776), 1);
  EXPECT_EQ(ink(*decal, 65, 75), 0);
  EXPECT_EQ(ink(*decal, 100, 100), 0);
  ASSERT_TRUE(decal->reach) << "only the surface that the eye sees";
}

TEST_F(PrintDecalTest, ShadowsAreAsDarkAsTheViewShowsThoseOfTheModel) {
  std::vector<std::uint8_t> pixels(kSize * kSize, 200);
  pixels[100 * kSize + 100] = 170;  // 0.402 of the light of white
  const auto shadow = printDecal(model_, placement_, pixels, kSize, true);
  ASSERT_TRUE(shadow);
  EXPECT_NEAR(ink(*shadow, 100, 100), 255 * (1 - std::pow(0.402 / 0.5776, 2.5)), 1);
}

TEST_F(PrintDecalTest, TheMarginEndsSoftly) {
  std::vector<std::uint8_t> pixels(kSize * kSize, 200);
  for (int row = 0; row < kSize / 8; ++row)
    for (int column = 0; column < kSize; ++column) pixels[static_cast<std::size_t>(row * kSize + column)] = 0;
  const auto decal = printDecal(model_, placement_, pixels, kSize, false);
  ASSERT_TRUE(decal);
  EXPECT_EQ(ink(*decal, 0, 150), 0);
  EXPECT_NEAR(ink(*decal, 10, 150), 128, 1);
  EXPECT_EQ(ink(*decal, 30, 150), 255);
}

}  // namespace
}  // namespace qrelief
