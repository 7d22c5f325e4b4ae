// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/shaped_floor_search.h"

#include <cmath>
#include <gtest/gtest.h>

#include "depth/light_neighbours.h"
#include "depth/pocket_sky.h"
#include "math/tolerance.h"
#include "support/pocket_light.h"

namespace qrelief::study {
namespace {

constexpr double kSymbolMm = 25;
constexpr double kSlackMm = 0.05;

/// Fixture with a real symbol on a plane, lit as PocketSky computes it, with interreflection.
class ShapedFloorSearchTest : public testing::Test {
 protected:
  ShapedFloorSearchTest()
      : symbol_(*encodeSymbol("https://qrelief.example", {})),
        mask_(submodulesToCarve(symbol_, ModulePattern::ThickPlus, FinderPattern::ThickPlusSharp)),
        sky_(mask_, kSymbolMm / mask_.rows()) {}

  ShapedFloorSearch run(FloorShape shape, double limitMm = 5, double contrast = 0.3) const {
    ShapedFloorSearch search({&symbol_, &mask_, kSymbolMm, std::vector<double>(mask_.size(), limitMm)},
                             {.shape = shape, .contrast = contrast, .slackMm = kSlackMm});
    while (!search.finished()) search.update(luminances(search.depths()));
    return search;
  }

  Grid<double> luminances(const DepthField& field) const { return pocketLuminances(sky_, field); }

  /// Returns the contrast of the carved part of every dark module, row-major.
  std::vector<double> contrasts(const DepthField& field) const {
    const Grid<double> all = luminances(field);
    std::vector<double> sums(symbol_.dark.size(), 0), counts(symbol_.dark.size(), 0);
    for (const std::uint32_t i : sky_.carved()) {
      const int row = static_cast<int>(i) / mask_.rows(), column = static_cast<int>(i) % mask_.rows();
      const auto module = static_cast<std::size_t>(row / 5 * symbol_.size + column / 5);
      sums[module] += 1 - luminanceOf(all, row, column);
      ++counts[module];
    }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = counts[i] > 0 ? sums[i] / counts[i] : 0;
    return sums;
  }

  Symbol symbol_;
  SubmoduleMask mask_;
  PocketSky sky_;
};

TEST(FloorWeight, RisesEvenlyAndMirrorsEveryOtherRowOfAWave) {
  for (int step = 0; step < 5; ++step) {
    EXPECT_EQ(floorWeight(FloorShape::Flat, 3, step, 5), 1);
    EXPECT_DOUBLE_EQ(floorWeight(FloorShape::Tilted, 3, step, 5), (step + 1) / 5.0);
    EXPECT_DOUBLE_EQ(floorWeight(FloorShape::Wavy, 2, step, 5), (step + 1) / 5.0);
    EXPECT_DOUBLE_EQ(floorWeight(FloorShape::Wavy, 3, step, 5), (5 - step) / 5.0);
  }
  EXPECT_EQ(floorWeight(FloorShape::Wavy, 2, 4, 5), floorWeight(FloorShape::Wavy, 3, 0, 5));
  EXPECT_EQ(floorWeight(FloorShape::Wavy, 3, 4, 5), floorWeight(FloorShape::Wavy, 4, 0, 5));
  EXPECT_DOUBLE_EQ(floorWeight(FloorShape::Tilted, 0, 2, 3), 1);
}

TEST_F(ShapedFloorSearchTest, MakesEveryModuleDarkEnoughAndHardlyDeeperThanNecessary) {
  for (const FloorShape shape : {FloorShape::Flat, FloorShape::Tilted, FloorShape::Wavy}) {
    const ShapedFloorSearch search = run(shape);
    EXPECT_LT(search.iterations(), 40) << floorShapeName(shape);
    EXPECT_EQ(search.doneFraction(), 1);
    EXPECT_EQ(search.limitedCount(), 0u);
    const std::vector<double> contrast = contrasts(search.depths());
    // If every module were shallower by twice the slack, few would be dark enough.
    DepthField less = search.depths();
    double deepest = 0;
    for (const double depth : less.depthMm) deepest = std::max(deepest, depth);
    for (double& depth : less.depthMm) depth *= 1 - 2 * kSlackMm / deepest;
    const std::vector<double> shallower = contrasts(less);
    int dark = 0, stillDark = 0;
    for (std::size_t i = 0; i < contrast.size(); ++i) {
      if (contrast[i] == 0) continue;
      EXPECT_GE(contrast[i], 0.3 - 1e-9);
      EXPECT_NEAR(contrast[i], search.contrasts()[i], 1e-9);
      ++dark;
      stillDark += shallower[i] >= 0.3;
    }
    EXPECT_LT(stillDark, 0.1 * dark) << floorShapeName(shape);
  }
}

TEST_F(ShapedFloorSearchTest, DepthsGrowRowByRowAndShrinkAgainInAWave) {
  for (const FloorShape shape : {FloorShape::Tilted, FloorShape::Wavy}) {
    const DepthField depths = run(shape).depths();
    for (int row = 0; row < symbol_.size; ++row)
      for (int column = 0; column < symbol_.size; ++column) {
        if (!symbol_.isDark(row, column)) continue;
        const bool isMirrored = shape == FloorShape::Wavy && row % 2 == 1;
        const double deepest = depths.depth(5 * row + (isMirrored ? 0 : 4), 5 * column + 2);
        for (int step = 0; step < 5; ++step)
          EXPECT_NEAR(depths.depth(5 * row + step, 5 * column + 2), (isMirrored ? 5 - step : step + 1) / 5.0 * deepest,
                      kDepthQuantumMm + 1e-9);
      }
  }
}

TEST_F(ShapedFloorSearchTest, StopsAtTheLimitsAndCountsModulesThatStayTooBright) {
  constexpr double kLimit = 0.105;
  const ShapedFloorSearch search = run(FloorShape::Tilted, kLimit);
  EXPECT_LT(search.iterations(), 40);
  for (const std::uint32_t i : sky_.carved()) EXPECT_LE(search.depths().depthMm[i], kLimit);
  EXPECT_GT(search.limitedCount(), 0.9 * static_cast<double>(sky_.carved().size()));
  EXPECT_EQ(search.doneFraction(), 1);
}

TEST_F(ShapedFloorSearchTest, LightModulesStayUncarved) {
  const DepthField depths = run(FloorShape::Wavy).depths();
  for (std::size_t i = 0; i < depths.depthMm.size(); ++i) EXPECT_EQ(depths.depthMm[i] > 0, mask_[i] != 0);
}

}  // namespace
}  // namespace qrelief::study
