// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/build_plate.h"

#include <cmath>
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

TEST(BuildPlate, LiesUnderTheModelAsWideAsItsBox) {
  const Mesh box = shapes::translated(shapes::box({30, 20, 10}), {5, 6, 7});
  const BuildPlate plate = plateUnder(box, {0, 0, 2});
  EXPECT_NEAR(glm::distance(plate.centre, Vec3(5, 6, 2)), 0, 1e-6);
  EXPECT_NEAR(glm::distance(plate.halfMm, Vec2(15, 10)), 0, 1e-6);
  EXPECT_NEAR(plate.heightMm, 10, 1e-6);
  EXPECT_NEAR(glm::distance(plate.right, Vec3(1, 0, 0)), 0, 1e-12);
}

TEST(BuildPlate, TouchesALeaningModelAtItsLowestPoint) {
  const Mesh box = shapes::box({30, 20, 10});
  const BuildPlate plate = plateUnder(box, {1, 0, 1});
  // The lowest edge is (-15, y, -5), the highest its opposite.
  EXPECT_NEAR(glm::dot(plate.centre, plate.up), -20 / std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(plate.heightMm, 40 / std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(plate.halfMm.y, 10, 1e-6);
}

TEST(BuildPlate, ItsAxesAreRightHandedInEveryPose) {
  for (const Vec3 up : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(-3, 2, 1)}) {
    const BuildPlate plate = plateUnder(shapes::box({1, 2, 3}), up);
    EXPECT_NEAR(glm::distance(glm::cross(plate.right, plate.back), plate.up), 0, 1e-12);
    EXPECT_NEAR(glm::length(plate.right), 1, 1e-12);
    EXPECT_NEAR(glm::distance(plate.up, glm::normalize(up)), 0, 1e-12);
  }
}

}  // namespace
}  // namespace qrelief
