// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/plate_layout.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

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

TEST(PlateLayout, TurnedCopiesStandBesideEachOtherAndAFailedOneLeavesItsPlaceFree) {
  std::vector<std::vector<ModelObject>> copies(4);
  for (const std::size_t i : {0u, 1u, 3u}) {
    ModelObject object{"part", {{"", shapes::box({10, 20, 60}), {}}}};
    object.up = {1, 0, 0};  // 60 × 20 mm on the plate
    copies[i] = namedCopy({object}, std::to_string(i), "text");
  }
  const std::vector<ModelObject> objects = onPlate(std::move(copies));
  ASSERT_EQ(objects.size(), 3u);
  EXPECT_EQ(objects[2].name, "3 part");
  EXPECT_EQ(objects[2].description, "text");
  EXPECT_EQ(objects[1].offsetMm - objects[0].offsetMm, Vec3(65, 0, 0));
  EXPECT_EQ(objects[2].offsetMm - objects[0].offsetMm, Vec3(65, 25, 0));
}

}  // namespace
}  // namespace qrelief
