// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/principal_axes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "base/random.h"

namespace qrelief {
namespace {

Vec3 randomUnit(Random& random) {
  for (;;) {
    const Vec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (glm::length(v) > 0.1 && glm::length(v) < 1) return glm::normalize(v);
  }
}

TEST(LeastVarianceAxis, OfPointsInAPlaneIsItsNormal) {
  Random random(1);
  for (int k = 0; k < 100; ++k) {
    const Vec3 normal = randomUnit(random);
    const Vec3 right = glm::normalize(glm::cross(normal, randomUnit(random)));
    const Vec3 up = glm::cross(normal, right);
    const Vec3 offset(random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-100, 100));
    std::vector<Vec3> points;
    for (int i = 0; i < 50; ++i)
      points.push_back(offset + right * random.uniform(-9, 9) + up * random.uniform(-20, 20));
    EXPECT_LT(glm::length(glm::cross(leastVarianceAxis(points), normal)), 1e-7);
  }
}

TEST(LeastVarianceAxis, OfACrossIsItsShortestArm) {
  const std::vector<Vec3> cross{{3, 0, 0}, {-3, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 2}, {0, 0, -2}};
  EXPECT_LT(glm::length(glm::abs(leastVarianceAxis(cross)) - Vec3(0, 1, 0)), 1e-12);
}

TEST(LeastVarianceAxis, VariesLessThanAnyOtherDirection) {
  Random random(2);
  for (int k = 0; k < 50; ++k) {
    std::vector<Vec3> points;
    for (int i = 0; i < 12; ++i)
      points.push_back({random.uniform(-1, 1), random.uniform(-2, 2), random.uniform(-2.5, 2.5)});
    const auto variance = [&](Vec3 axis) {
      double sum = 0, squares = 0;
      for (const Vec3 p : points) {
        sum += glm::dot(p, axis);
        squares += glm::dot(p, axis) * glm::dot(p, axis);
      }
      return squares / 12 - sum * sum / 144;
    };
    const Vec3 axis = leastVarianceAxis(points);
    EXPECT_NEAR(glm::length(axis), 1, 1e-12);
    for (int i = 0; i < 200; ++i) EXPECT_LE(variance(axis), variance(randomUnit(random)) + 1e-12);
    for (int i = 0; i < 50; ++i)
      EXPECT_LE(variance(axis), variance(glm::normalize(axis + 1e-3 * randomUnit(random))) + 1e-12);
  }
}

TEST(LeastVarianceAxis, OfFewerThanThreePointsIsZero) {
  EXPECT_EQ(leastVarianceAxis({}), Vec3(0));
  const std::vector<Vec3> two{{1, 2, 3}, {2, 3, 4}};
  EXPECT_EQ(leastVarianceAxis(two), Vec3(0));
}

}  // namespace
}  // namespace qrelief
