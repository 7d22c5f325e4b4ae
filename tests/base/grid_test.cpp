// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/grid.h"

#include <gmock/gmock.h>

namespace qrelief {
namespace {

TEST(Grid, IsRowMajor) {
  Grid<int> grid(2, 3);
  grid.at(0, 2) = 1;
  grid.at(1, 0) = 2;
  EXPECT_THAT(grid.values(), testing::ElementsAre(0, 0, 1, 2, 0, 0));
  EXPECT_EQ(grid.index(1, 2), 5u);
}

TEST(Grid, ContainsItsCellsOnly) {
  const Grid<int> grid(2, 3);
  EXPECT_TRUE(grid.contains(0, 0) && grid.contains(1, 2));
  EXPECT_FALSE(grid.contains(-1, 0) || grid.contains(0, -1) || grid.contains(2, 0) || grid.contains(0, 3));
}

TEST(Grid, TheBottomUpGridHasItsRowsInTheOtherOrder) {
  EXPECT_EQ(bottomUp(Grid<int>(2, 3, {1, 2, 3, 4, 5, 6})), BottomUp<int>(2, 3, {4, 5, 6, 1, 2, 3}));
  EXPECT_TRUE(bottomUp(Grid<int>()).empty());
}

}  // namespace
}  // namespace qrelief
