// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/grid_march.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

// Just behind each border that the ray crosses, it lies in the cell it entered.
TEST(GridMarch, VisitsTheCellsAlongTheRayInOrder) {
  for (int k = 0; k < 48; ++k) {
    const double angle = 2 * 3.14159265358979 * (k + 0.5) / 48;
    const Vec2 along(std::cos(angle), std::sin(angle)), place(0.2, 0.7);
    GridMarch march({3, -2}, place, along);
    double before = 0;
    for (int i = 0; i < 30; ++i) {
      const double distance = march.step();
      EXPECT_GT(distance, before);
      const Vec2 behind = Vec2(3, -2) + place + along * (distance + 1e-9);
      EXPECT_EQ(march.cell(), glm::ivec2(glm::floor(behind))) << "direction " << k << ", step " << i;
      before = distance;
    }
  }
}

TEST(GridMarch, ReturnsTheDistanceToTheCrossedBorder) {
  GridMarch march({0, 0}, {0.5, 0.5}, {0.6, 0.8});
  EXPECT_DOUBLE_EQ(march.step(), 0.5 / 0.8);
  EXPECT_EQ(march.cell(), glm::ivec2(0, 1));
  EXPECT_DOUBLE_EQ(march.step(), 0.5 / 0.6);
  EXPECT_EQ(march.cell(), glm::ivec2(1, 1));
  EXPECT_DOUBLE_EQ(march.step(), 1.5 / 0.8);
  EXPECT_EQ(march.cell(), glm::ivec2(1, 2));
}

}  // namespace
}  // namespace qrelief
