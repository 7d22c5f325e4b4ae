// SPDX-License-Identifier: GPL-3.0-or-later
#include "label/ring_coverage.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

namespace qrelief {
namespace {

Ring box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

TEST(RingCoverage, APixelHasTheAreaThatARectangleCoversOfIt) {
  // 4 × 4 pixels of one unit; the box covers a pixel, half of its right neighbour, and a quarter of the height above.
  const std::array rings = {box(-1, -1, 0.5, 0.25)};
  const std::vector<std::uint8_t> expected = {0, 0,   0,   0,  //
                                              0, 64,  32,  0,  //
                                              0, 255, 128, 0,  //
                                              0, 0,   0,   0};
  EXPECT_EQ(ringCoverage(rings, 4, 4), expected);
}

TEST(RingCoverage, RingsWithinRingsAreHoles) {
  Ring hole = box(-1, -1, 1, 1);
  std::reverse(hole.begin(), hole.end());
  const std::array rings = {box(-2, -2, 2, 2), hole};
  const std::vector<std::uint8_t> expected = {255, 255, 255, 255,  //
                                              255, 0,   0,   255,  //
                                              255, 0,   0,   255,  //
                                              255, 255, 255, 255};
  EXPECT_EQ(ringCoverage(rings, 4, 4), expected);
}

TEST(RingCoverage, PartsOutsideThePictureAreCutOff) {
  const std::array rings = {box(-9, -9, 0, 9), box(7, 7, 9, 9)};
  EXPECT_EQ(ringCoverage(rings, 2, 4), (std::vector<std::uint8_t>{255, 0, 255, 0}));
}

TEST(RingCoverage, ADiscKeepsItsArea) {
  Ring disc;
  for (int k = 0; k < 720; ++k) {
    const double angle = k * std::numbers::pi / 360;
    disc.emplace_back(std::cos(angle), std::sin(angle));
  }
  constexpr int kPixels = 50;
  const std::array rings = {disc};
  const auto coverage = ringCoverage(rings, kPixels, 3);
  const double sum = std::accumulate(coverage.begin(), coverage.end(), 0.0) / 255;
  EXPECT_NEAR(sum * std::pow(3.0 / kPixels, 2), std::numbers::pi, 0.005);
}

}  // namespace
}  // namespace qrelief
