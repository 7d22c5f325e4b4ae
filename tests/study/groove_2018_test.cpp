// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/methods/groove_2018.h"

#include <gmock/gmock.h>

#include "study/study_spots.h"

namespace qrelief::study {
namespace {

using Groove2018 = PlateTest;

TEST_F(Groove2018, SplineOfEvenDepthIsEvenAndFadesOutAtItsRim) {
  const std::vector<double> values = bSplineValues(std::vector<double>(49, 3.0), 7);
  EXPECT_DOUBLE_EQ(values[24], 3);             // in the middle
  EXPECT_DOUBLE_EQ(values[21], 3.0 * 5 / 6);   // at a border
  EXPECT_DOUBLE_EQ(values[0], 3.0 * 25 / 36);  // at a corner
}

TEST_F(Groove2018, SplineOfOneControlPointSpreadsOverItsNeighbours) {
  std::vector<double> control(25, 0);
  control[12] = 36;
  const std::vector<double> values = bSplineValues(control, 5);
  EXPECT_DOUBLE_EQ(values[12], 16);
  EXPECT_DOUBLE_EQ(values[11], 4);
  EXPECT_DOUBLE_EQ(values[6], 1);
  EXPECT_DOUBLE_EQ(values[10], 0);
}

TEST_F(Groove2018, LoneModuleEndsDarkEnoughAndSmooth) {
  const StudyPlacement spot = plateSpot(2);
  const Symbol symbol = withOneDarkModule(spot);
  const SubmoduleMask mask = submodulesToCarve(symbol, ModulePattern::None, FinderPattern::None);
  const GrooveOptions options;
  const auto code = carveGrooves2018(spot, symbol, mask, options);
  ASSERT_TRUE(code.has_value());
  EXPECT_EQ(code->limited, 0u);
  for (const double obscurance : code->ownEstimate) EXPECT_LE(obscurance, 1 - options.contrast);
  // The groove is deepest in the middle; the adjacent light module is carved a little.
  const std::vector<std::uint32_t> carved = carvedOf(mask);
  const auto depth = [&](std::uint32_t i) { return code->depths.depthMm[i]; };
  EXPECT_GT(depth(carved[12]), depth(carved[10]));
  EXPECT_GT(depth(carved[10] - 1), 0);
  EXPECT_LT(depth(carved[10] - 1), depth(carved[10]));
  EXPECT_EQ(depth(carved[10] - 2), 0);
}

}  // namespace
}  // namespace qrelief::study
