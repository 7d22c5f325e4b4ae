// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/orientation.h"

#include <gtest/gtest.h>

#include "base/random.h"

namespace qrelief {
namespace {

__extension__ using Wide = __int128;

/// Returns the determinant's sign in integer arithmetic; coordinates up to 2^39.
int exactSide(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const auto whole = [](double x) { return static_cast<Wide>(x); };
  const Wide px = whole(b.x) - whole(a.x), py = whole(b.y) - whole(a.y), pz = whole(b.z) - whole(a.z);
  const Wide qx = whole(c.x) - whole(a.x), qy = whole(c.y) - whole(a.y), qz = whole(c.z) - whole(a.z);
  const Wide rx = whole(d.x) - whole(a.x), ry = whole(d.y) - whole(a.y), rz = whole(d.z) - whole(a.z);
  const Wide determinant = rx * (py * qz - pz * qy) + ry * (pz * qx - px * qz) + rz * (px * qy - py * qx);
  return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

TEST(SideOfPlane, IsPositiveWhereTheCornersTurnCounterClockwise) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(sideOfPlane(a, b, c, {0.3, 0.3, 1}), 1);
  EXPECT_EQ(sideOfPlane(a, b, c, {0.3, 0.3, -1}), -1);
  EXPECT_EQ(sideOfPlane(a, b, c, {7, -5, 0}), 0);
}

TEST(SideOfPlane, IsExactForPointsAlmostInThePlane) {
  Random random(11);
  const auto coordinate = [&] { return std::floor(random.uniform(-0x1p36, 0x1p36)); };
  int zeros = 0;
  for (int k = 0; k < 4096; ++k) {
    const Vec3 a(coordinate(), coordinate(), coordinate());
    const Vec3 b(coordinate(), coordinate(), coordinate());
    const Vec3 c(coordinate(), coordinate(), coordinate());
    const double i = static_cast<double>(random.below(3)) - 1;
    const double j = static_cast<double>(random.below(3)) - 1;
    const double off = static_cast<double>(random.below(3)) - 1;
    const Vec3 d = a + (b - a) * i + (c - a) * j + Vec3(off, 0, off);
    const int expected = exactSide(a, b, c, d);
    zeros += expected == 0;
    ASSERT_EQ(sideOfPlane(a, b, c, d), expected);
    ASSERT_EQ(sideOfPlane(b, a, c, d), -expected);
  }
  EXPECT_GT(zeros, 1000);  // a third of the points lie in the plane
}

}  // namespace
}  // namespace qrelief
