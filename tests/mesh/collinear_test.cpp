// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/collinear.h"

#include <cmath>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

TEST(Collinear, IsExactForTheSmallestStepOfAFloat) {
  const Vec3f a(0.1f, 0.2f, 0.3f);
  const Vec3f b(0.2f, 0.4f, 0.6f);
  const Vec3f c(0.4f, 0.8f, 1.2f);
  EXPECT_TRUE(collinear(a, b, c));  // exactly b = 2a, c = 4a
  EXPECT_FALSE(collinear(a, b, {c.x, c.y, std::nextafter(c.z, 2.0f)}));
}

TEST(Collinear, DetectsAMicrometreAtAKilometre) {
  const Vec3f a(1e6f, 0, 0);
  const Vec3f b(1e6f + 1, 0, 0);
  EXPECT_TRUE(collinear(a, b, {0, 0, 0}));
  EXPECT_FALSE(collinear(a, b, {0, 1e-40f, 0}));  // a denormal float
}

TEST(Collinear, IsTrueForEqualPoints) {
  const Vec3f p(1, 2, 3);
  EXPECT_TRUE(collinear(p, p, {5, 5, 5}));
  EXPECT_TRUE(collinear(p, p, p));
}

TEST(Collinear, IsFalseForTrianglesInCoordinatePlanes) {
  EXPECT_FALSE(collinear({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(collinear({0, 0, 0}, {0, 1, 0}, {0, 0, 1}));
  EXPECT_FALSE(collinear({0, 0, 0}, {0, 0, 1}, {1, 0, 0}));
}

}  // namespace
}  // namespace qrelief
