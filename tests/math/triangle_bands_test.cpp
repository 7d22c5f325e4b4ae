// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/triangle_bands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "math/vec.h"

namespace qrelief {
namespace {

TEST(TriangleBands, TheRowsOfALongThinTriangleCostItsLength) {
  for (const int length : {100, 1000, 10000}) {
    const Vec2 a{0, 0}, b{length, length - 0.4}, c{length - 0.4, length};
    const TriangleBands<double> bands(a, b, c);
    double columns = 0;
    for (int row = 0; row < length; ++row) {
      const auto [least, greatest] = bands.between(row, row + 1);
      columns += std::max(0.0, greatest - least);
    }
    EXPECT_LE(columns, 3 * length) << length;
  }
}

TEST(TriangleTexels, OfASliverAreFewMoreThanItsMiddles) {
  for (const glm::vec2 end : {glm::vec2(400, 40), {40, 400}, {7, 400}, {400, 7}, {300, 300}}) {
    const glm::vec2 a(3, 2), b = a + end, c = b + glm::vec2(-0.2f, 0.2f);
    const TriangleTexels<float> texels(a, b, c, 512);
    int looked = 0;
    for (int row = texels.rows().first; row <= texels.rows().last; ++row)
      looked += std::max(0, texels.columns(row).last - texels.columns(row).first + 1);
    EXPECT_LE(static_cast<float>(looked), 2 * (end.x + end.y)) << end.x << ", " << end.y;
  }
}

TEST(TriangleTexels, HoldEveryMiddleInATriangle) {
  constexpr int kTexels = 64;
  Random random(9);
  for (int i = 0; i < 500; ++i) {
    std::array<glm::vec2, 3> corners;
    for (auto& corner : corners)
      corner = glm::vec2(Vec2(random.uniform(-5, kTexels + 5), random.uniform(-5, kTexels + 5)));
    if (i % 2 == 0) corners[2] = corners[1] + 0.3f * (corners[2] - corners[1]) / 64.0f;  // a sliver
    const auto& [a, b, c] = corners;
    const TriangleTexels<float> texels(a, b, c, kTexels);
    for (int row = 0; row < kTexels; ++row)
      for (int column = 0; column < kTexels; ++column) {
        const glm::vec2 p(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f);
        const auto side = [&](glm::vec2 from, glm::vec2 to) {
          return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
        };
        const float s = side(a, b), t = side(b, c), u = side(c, a);
        if (std::min({s, t, u}) < 0 && std::max({s, t, u}) > 0) continue;
        EXPECT_TRUE(row >= texels.rows().first && row <= texels.rows().last);
        EXPECT_TRUE(column >= texels.columns(row).first && column <= texels.columns(row).last);
      }
  }
}

TEST(TriangleBands, HoldsEveryPointOfTheTriangle) {
  Random random(5);
  const auto point = [&] { return Vec2{20 * random.uniform(), 20 * random.uniform()}; };
  for (int i = 0; i < 2000; ++i) {
    const Vec2 a = point(), b = point(), c = point();
    const double u = random.uniform(), v = (1 - u) * random.uniform();
    const Vec2 inside = a + u * (b - a) + v * (c - a);
    const double low = std::floor(inside.y);
    const auto [least, greatest] = TriangleBands<double>(a, b, c).between(low, low + 1);
    EXPECT_LE(least, inside.x + 1e-9);
    EXPECT_GE(greatest, inside.x - 1e-9);
    EXPECT_GE(least, std::min({a.x, b.x, c.x}) - 1e-9);
    EXPECT_LE(greatest, std::max({a.x, b.x, c.x}) + 1e-9);
  }
}

TEST(TriangleBands, IsEmptyAboveAndBelow) {
  const Vec2 a{0, 0}, b{4, 1}, c{2, 3};
  for (const double low : {-2.0, 3.5}) {
    const auto [least, greatest] = TriangleBands<double>(a, b, c).between(low, low + 1);
    EXPECT_GT(least, greatest);
  }
}

TEST(TriangleBands, KnowsTrianglesWithoutArea) {
  const auto expectRange = [](const TriangleBands<double>& bands, double low, double high, double least,
                              double greatest) {
    const auto range = bands.between(low, high);
    EXPECT_DOUBLE_EQ(range.least, least);
    EXPECT_DOUBLE_EQ(range.greatest, greatest);
  };
  const Vec2 a{1, 2}, b{5, 2}, c{3, 2}, d{5, 6};
  expectRange({a, b, c}, 1, 3, 1, 5);
  expectRange({a, b, b}, 2, 2, 1, 5);
  expectRange({a, a, a}, 2, 3, 1, 1);
  expectRange({a, d, d}, 3, 4, 2, 3);
}

}  // namespace
}  // namespace qrelief
