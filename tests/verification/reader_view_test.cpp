// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/reader_view.h"

#include <cmath>
#include <gtest/gtest.h>

#include "verification/reading_variants.h"

namespace qrelief {
namespace {

TEST(Photograph, ExposesTheBrightPartToItsLevelAndFlipsTheRows) {
  // Bottom half at luminance 0.5, top half at 0.25.
  BottomUp<float> luminance(100, 100, 0.5f);
  std::fill(luminance.begin() + 5000, luminance.end(), 0.25f);
  const GreyImage image = photograph(luminance);
  // sRGB of 0.85 and 0.425: 1.055·x^(1/2.4) - 0.055.
  EXPECT_EQ(image.pixels[99 * 100], 237);
  EXPECT_EQ(image.pixels[0], 174);
}

TEST(Photograph, StrayLightRaisesTheDarkPartTowardsTheMean) {
  BottomUp<float> luminance(100, 100, 1);
  for (std::size_t i = 0; i < luminance.size(); i += 2) luminance[i] = 0.0f;
  const GreyImage clean = photograph(luminance);
  const GreyImage stray = photograph(luminance, {.strayLight = 0.1});
  EXPECT_EQ(clean.pixels[0], 0);
  // Stray light is 10 % of the mean 0.5, exposed by 0.85: 0.0425 linear.
  EXPECT_EQ(stray.pixels[0], 58);
}

TEST(Photograph, NoiseHasTheGivenStandardDeviationAndIsDeterministic) {
  const BottomUp<float> luminance(200, 200, 1);
  const GreyImage first = photograph(luminance, {.noise = 0.02});
  EXPECT_EQ(first.pixels, photograph(luminance, {.noise = 0.02}).pixels);
  double sum = 0, squares = 0;
  for (const std::uint8_t pixel : first.pixels) {
    const double s = pixel / 255.0;
    const double linear = std::pow((s + 0.055) / 1.055, 2.4);
    sum += linear;
    squares += linear * linear;
  }
  const double n = static_cast<double>(first.pixels.size());
  const double mean = sum / n;
  EXPECT_NEAR(mean, 0.85, 0.002);
  EXPECT_NEAR(std::sqrt(squares / n - mean * mean), 0.02, 0.001);
}

TEST(Blurred, ASinglePointBecomesTheGaussian) {
  GreyImage point{41, 41, std::vector<std::uint8_t>(41 * 41, 0)};
  point.pixels[20 * 41 + 20] = 255;
  const GreyImage soft = blurred(point, 1.0);
  EXPECT_NEAR(soft.pixels[20 * 41 + 20], 255 / (2 * 3.14159265), 1);
  EXPECT_NEAR(soft.pixels[20 * 41 + 21], 255 / (2 * 3.14159265) * std::exp(-0.5), 1);
  EXPECT_EQ(blurred(point, 0).pixels, point.pixels);
}

TEST(ReadingVariants, TheFirstIsThePictureItselfAndTheSecondUsesTheWholeRange) {
  GreyImage faint{60, 60, std::vector<std::uint8_t>(3600, 120)};
  for (std::size_t i = 0; i < 1800; ++i) faint.pixels[i] = 140;
  const auto variants = readingVariants(faint, 8);
  ASSERT_EQ(variants.size(), 6u);
  EXPECT_EQ(variants[0].pixels, faint.pixels);
  EXPECT_EQ(variants[1].pixels[0], 255);
  EXPECT_EQ(variants[1].pixels[3599], 0);
  EXPECT_EQ(variants[4].width, 30);
  EXPECT_EQ(variants[5].width, 20);
}

}  // namespace
}  // namespace qrelief
