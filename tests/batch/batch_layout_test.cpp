// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_layout.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

TEST(BatchLayout, ARowIsAUnitWithoutPlates) {
  const BatchLayout layout = {.rows = 3};
  EXPECT_EQ(layout.count(), 3u);
  EXPECT_EQ(layout.of(2), 2u);
  EXPECT_EQ(layout.begin(2), 2u);
  EXPECT_EQ(layout.end(2), 3u);
  EXPECT_EQ(layout.plate(2), "");
}

TEST(BatchLayout, TheLastPlateMayHoldFewerRows) {
  const BatchLayout layout = {.rows = 8, .perPlate = 3};
  EXPECT_EQ(layout.count(), 3u);
  EXPECT_EQ(layout.of(5), 1u);
  EXPECT_EQ(layout.begin(2), 6u);
  EXPECT_EQ(layout.end(2), 8u);
  EXPECT_EQ(layout.plate(2), "plate-003.3mf");
}

TEST(BatchLayout, CountsTheRowsOfAShare) {
  const BatchLayout layout = {.rows = 8, .perPlate = 3};
  EXPECT_EQ(layout.rowsOf({}), 8u);
  EXPECT_EQ(layout.rowsOf({0, 2}), 5u);
  EXPECT_EQ(layout.rowsOf({1, 2}), 3u);
}

TEST(BatchLayout, ASeriesNamesPlatesByTheirFirstRow) {
  const BatchLayout layout = {.rows = 5, .perPlate = 2, .firstNumber = 1001};
  EXPECT_EQ(layout.plate(0), "plate-1001.3mf");
  EXPECT_EQ(layout.plate(2), "plate-1005.3mf");
  EXPECT_EQ(layout.rowOf(1001), 0u);
  EXPECT_EQ(layout.rowOf(1005), 4u);
  EXPECT_EQ(layout.rowOf(7), layout.rows) << "a row of another series";
}

TEST(BatchLayout, PrintsEveryNthRowFromTheFirst) {
  const BatchLayout layout = {.rows = 7, .printEvery = 3};
  std::vector<std::size_t> printed;
  for (std::size_t row = 0; row < layout.rows; ++row)
    if (layout.printsRow(row)) printed.push_back(row);
  EXPECT_EQ(printed, (std::vector<std::size_t>{0, 3, 6}));
}

}  // namespace
}  // namespace qrelief
