// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/triangle_band.h"

#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "math/vec.h"

namespace qrelief {
namespace {

TEST(TriangleBand, TheRowsOfALongThinTriangleCostItsLength) {
  for (const int length : {100, 1000, 10000}) {
    const Vec2 a{0, 0}, b{length, length - 0.4}, c{length - 0.4, length};
    double columns = 0;
    for (int row = 0; row < length; ++row) {
      const auto [least, greatest] = rangeInBand<double>(a, b, c, row, row + 1);
      columns += std::max(0.0, greatest - least);
    }
    EXPECT_LE(columns, 3 * length) << length;
  }
}

TEST(TriangleBand, HoldsEveryPointOfTheTriangle) {
  Random random(5);
  const auto point = [&] { return Vec2{20 * random.uniform(), 20 * random.uniform()}; };
  for (int i = 0; i < 2000; ++i) {
    const Vec2 a = point(), b = point(), c = point();
    const double u = random.uniform(), v = (1 - u) * random.uniform();
    const Vec2 inside = a + u * (b - a) + v * (c - a);
    const double low = std::floor(inside.y);
    const auto [least, greatest] = rangeInBand<double>(a, b, c, low, low + 1);
    EXPECT_LE(least, inside.x + 1e-9);
    EXPECT_GE(greatest, inside.x - 1e-9);
    EXPECT_GE(least, std::min({a.x, b.x, c.x}) - 1e-9);
    EXPECT_LE(greatest, std::max({a.x, b.x, c.x}) + 1e-9);
  }
}

TEST(TriangleBand, IsEmptyAboveAndBelow) {
  const Vec2 a{0, 0}, b{4, 1}, c{2, 3};
  for (const double low : {-2.0, 3.5}) {
    const auto [least, greatest] = rangeInBand<double>(a, b, c, low, low + 1);
    EXPECT_GT(least, greatest);
  }
}

}  // namespace
}  // namespace qrelief
