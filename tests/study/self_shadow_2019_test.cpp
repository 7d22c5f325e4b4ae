// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/self_shadow_2019.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

#include "study/study_spots.h"

namespace qrelief::study {
namespace {

using testing::AllOf;
using testing::Ge;
using testing::Le;

using SelfShadow2019 = PlateTest;

TEST_F(SelfShadow2019, GreyLevelsMatchTheFit) {
  EXPECT_EQ(selfShadowGrey(1), 196);
  EXPECT_EQ(selfShadowGrey(0.1), 158);  // 195.6 · 0.8088
  EXPECT_EQ(selfShadowGrey(0), 0);
}

/// Returns the visibility from the middle of the floor of a pit as wide as it is long: a share F of the sky [view
/// factor of a rectangle] in a solid angle A.
double pitVisibility(double halfWidthMm, double depthMm) {
  const double x = halfWidthMm / depthMm, s = x / std::sqrt(1 + x * x);
  const double share = 4 / std::numbers::pi * s * std::atan(s), angle = 4 * std::asin(x * x / (1 + x * x));
  return share * angle / std::numbers::pi;
}

TEST_F(SelfShadow2019, LonePitIsAsDeepAsItsGreyLevelRequires) {
  const StudyPlacement spot = plateSpot(2);
  const Symbol symbol = withOneDarkModule(spot);
  SubmoduleMask mask = submodulesToCarve(symbol, ModulePattern::None, FinderPattern::None);
  const std::uint32_t middle = carvedOf(mask)[12];
  mask = {mask.rows(), mask.rows()};
  mask[middle] = 1;
  SelfShadowOptions options;
  options.rays = 4096;
  options.stepModules = 0.05;
  const auto code = carveSelfShadow2019(spot, symbol, mask, options);
  ASSERT_TRUE(code.has_value());
  const double stepMm = options.stepModules * spot.placement.moduleMm;
  double expectedMm = stepMm;
  while (selfShadowGrey(pitVisibility(spot.submoduleMm() / 2, expectedMm)) > 196 - 0.2 * 255) expectedMm += stepMm;
  EXPECT_NEAR(code->depths.depthMm[middle], expectedMm, stepMm);
  EXPECT_NEAR(code->ownEstimate[0], pitVisibility(spot.submoduleMm() / 2, code->depths.depthMm[middle]), 0.004);
}

/// Returns the mean number of steps of the modules for which a condition holds.
template <class Condition>
double meanSteps(const CarvedCode& code, double stepMm, const Condition& condition) {
  double sum = 0;
  int count = 0;
  for (const std::uint32_t i : carvedOf(code.mask)) {
    const int row = static_cast<int>(i) / code.mask.rows() / kSubmodulesPerModule,
              column = static_cast<int>(i) % code.mask.rows() / kSubmodulesPerModule;
    if (!condition(row, column)) continue;
    sum += code.depths.depthMm[i] / stepMm;
    ++count;
  }
  return count > 0 ? sum / count : std::nan("");
}

/// Compares with the authors' logged run of June 2017: version 2, 7750 dark submodules, 18 passes. Steps per submodule:
/// mean 7.02, 90 % up to 10, at most 16. A finder pattern's ring took 7 to 10 steps, its core 6 to 9, lone modules 3 to
/// 4. The ring takes 6.2 steps here: self_shadow_2019.h says why.
TEST_F(SelfShadow2019, StepsOnAPlateMatchTheAuthorsLog) {
  const StudyPlacement spot = plateSpot(2);
  const SubmoduleMask mask = submodulesToCarve(spot.symbol, ModulePattern::None, FinderPattern::None);
  SelfShadowOptions options;
  options.rays = 128;
  const auto code = carveSelfShadow2019(spot, spot.symbol, mask, options);
  ASSERT_TRUE(code.has_value());
  const double stepMm = options.stepModules * spot.placement.moduleMm;
  const auto isDark = [&](int row, int column) {
    return row >= 0 && column >= 0 && row < code->symbol.size && column < code->symbol.size &&
           code->symbol.isDark(row, column);
  };
  const auto isRing = [](int row, int column) {
    return row < 7 && column < 7 && (row == 0 || column == 0 || row == 6 || column == 6);
  };
  const auto isCore = [](int row, int column) { return row >= 2 && row <= 4 && column >= 2 && column <= 4; };
  const auto isLone = [&](int row, int column) {
    return !isDark(row - 1, column) && !isDark(row + 1, column) && !isDark(row, column - 1) && !isDark(row, column + 1);
  };
  const auto everywhere = [](int, int) { return true; };
  EXPECT_THAT(meanSteps(*code, stepMm, everywhere), AllOf(Ge(0.8 * 7.02), Le(1.2 * 7.02)));
  EXPECT_THAT(meanSteps(*code, stepMm, isRing), AllOf(Ge(6), Le(10)));
  EXPECT_THAT(meanSteps(*code, stepMm, isCore), AllOf(Ge(6), Le(9)));
  EXPECT_THAT(meanSteps(*code, stepMm, isLone), AllOf(Ge(0.8 * 3), Le(4)));
  EXPECT_EQ(code->limited, 0u);
}

}  // namespace
}  // namespace qrelief::study
