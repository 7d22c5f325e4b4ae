// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/resample.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

/// Returns a picture with value = column + 10·row.
Grid<float> ramp(int width) {
  Grid<float> picture(width, width);
  for (int y = 0; y < width; ++y)
    for (int x = 0; x < width; ++x) picture.at(y, x) = static_cast<float>(x + 10 * y);
  return picture;
}

TEST(Resampled, AStepOfOnePixelChangesNothing) { EXPECT_EQ(resampled(ramp(7), 1), ramp(7)); }

TEST(Resampled, CellsAreMeansOfTheirAreas) {
  const Grid<float> halved = resampled(ramp(4), 2);
  ASSERT_EQ(halved.size(), 4u);
  EXPECT_FLOAT_EQ(halved[0], 5.5f);   // 0, 1, 10, 11
  EXPECT_FLOAT_EQ(halved[1], 7.5f);   // 2, 3, 12, 13
  EXPECT_FLOAT_EQ(halved[2], 25.5f);  // 20, 21, 30, 31
}

TEST(Resampled, PixelsOnTheBorderOfACellCountByTheirShare) {
  // Cells are 1.5 pixels wide: 0 and half of 1; half of 1 and 2.
  const Grid<float> cells = resampled(Grid<float>(3, 3, {0, 1, 2, 0, 1, 2, 0, 1, 2}), 1.5);
  ASSERT_EQ(cells.size(), 4u);
  EXPECT_FLOAT_EQ(cells[0], 0.5f / 1.5f);
  EXPECT_FLOAT_EQ(cells[1], 2.5f / 1.5f);
  EXPECT_EQ(resampled(ramp(410), 10 / 6.5).columns(), 266);
}

TEST(Resampled, APhaseShiftsTheGridAndExtendsTheBorder) {
  const Grid<float> rows(4, 4, {0, 2, 4, 6, 0, 2, 4, 6, 0, 2, 4, 6, 0, 2, 4, 6});
  const Grid<float> shifted = resampled(rows, 2, {0.5, 0});
  EXPECT_FLOAT_EQ(shifted[0], 3);  // 2, 4
  EXPECT_FLOAT_EQ(shifted[1], 6);  // 6, and 6 again beyond the border
}

}  // namespace
}  // namespace qrelief
