// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/box.h"

#include <cmath>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

TEST(Box3, IsEmptyAndWithoutSizeUntilAPointIsAdded) {
  Box3 box;
  EXPECT_TRUE(box.empty());
  EXPECT_EQ(box.size(), Vec3(0));
  box.add({1, 2, 3});
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.size(), Vec3(0));
  EXPECT_EQ(box.centre(), Vec3(1, 2, 3));
}

TEST(Box3, SpansItsPoints) {
  Box3 box;
  for (const Vec3 p : {Vec3(1, 5, -2), Vec3(-3, 0, 4)}) box.add(p);
  EXPECT_EQ(box.min, Vec3(-3, 0, -2));
  EXPECT_EQ(box.max, Vec3(1, 5, 4));
  EXPECT_EQ(box.centre(), Vec3(-1, 2.5, 1));
  EXPECT_DOUBLE_EQ(box.diagonal(), std::sqrt(16.0 + 25 + 36));
}

}  // namespace
}  // namespace qrelief
