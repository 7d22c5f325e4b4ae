// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/plate_layout.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

TEST(PlateLayout, PlacesCopiesSideBySideWithGapsAndNoOverlap) {
  const Box3 box{Vec3(-10.003, 4, -2), Vec3(20, 14.5, 3)};
  for (const std::size_t copies : {1u, 2u, 5u, 9u, 10u}) {
    const std::vector<Vec3> offsets = plateOffsets(box, copies);
    ASSERT_EQ(offsets.size(), copies);
    for (std::size_t i = 0; i < copies; ++i) {
      const Vec3 low = box.min + offsets[i];
      EXPECT_GE(low.x, 0);
      EXPECT_GE(low.y, 0);
      EXPECT_NEAR(low.z, 0, 1e-12);
      for (std::size_t k = 0; k < i; ++k) {
        const Vec3 apart = glm::abs(offsets[i] - offsets[k]) - box.size();
        EXPECT_GE(std::max(apart.x, apart.y), 5 - 0.011);
      }
    }
  }
}

TEST(PlateLayout, PadsPlateNamesSoThatTheySort) {
  EXPECT_EQ(plateName(0, 4), "plate-001.3mf");
  EXPECT_EQ(plateName(6, 1200), "plate-0007.3mf");
}

TEST(PlateLayout, LaysNineCopiesOutThreeByThree) {
  const std::vector<Vec3> offsets = plateOffsets({Vec3(0), Vec3(10, 10, 5)}, 9);
  EXPECT_EQ(offsets[0], Vec3(0));
  EXPECT_EQ(offsets[8], Vec3(30, 30, 0));
}

}  // namespace
}  // namespace qrelief
