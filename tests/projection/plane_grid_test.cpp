// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/plane_grid.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <set>

#include "base/random.h"

namespace qrelief {
namespace {

bool segmentsMeet(const Triangle2& segment, const Triangle2& triangle) {
  for (std::size_t k = 0; k < 3; ++k)
    if (distanceBetween({segment[0], segment[1]}, {triangle[k], triangle[(k + 1) % 3]}) == 0) return true;
  return distanceToTriangle(segment[0], triangle) == 0;
}

Triangle2 randomSegment(Random& random, double extent) {
  const Vec2 a(random.uniform(-extent, extent), random.uniform(-extent, extent));
  const Vec2 b = random.below(4) == 0 ? Vec2(random.uniform(-extent, extent), random.uniform(-extent, extent))
                                      : a + Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
  return {a, b, b};
}

Triangle2 randomTriangle(Random& random, double extent) {
  const double size = random.below(5) == 0 ? extent : 1;
  const Vec2 a(random.uniform(-extent, extent), random.uniform(-extent, extent));
  Triangle2 t{a, a + Vec2(random.uniform(-size, size), random.uniform(-size, size)),
              a + Vec2(random.uniform(-size, size), random.uniform(-size, size))};
  if (cross2(t[1] - t[0], t[2] - t[0]) < 0) std::swap(t[1], t[2]);
  return t;
}

void expectToFindAll(double halfWidth) {
  Random random(5);
  std::vector<Triangle2> segments;
  for (int k = 0; k < 400; ++k) segments.push_back(randomSegment(random, 20));
  PlaneGrid grid(segments, halfWidth);
  for (int k = 0; k < 400; ++k) {
    const Triangle2 query = randomTriangle(random, 30);
    const std::span<const std::uint32_t> near = grid.near(query);
    const std::set<std::uint32_t> unique(near.begin(), near.end());
    EXPECT_EQ(unique.size(), near.size()) << "a shape was found twice";
    EXPECT_EQ(grid.anyNear(query), !near.empty());
    for (std::uint32_t s = 0; s < segments.size(); ++s)
      ASSERT_TRUE(unique.count(s) || !segmentsMeet(segments[s], query)) << "segment " << s << ", query " << k;
  }
}

TEST(PlaneGrid, FindsEveryShapeThatMeetsTheQuery) { expectToFindAll(std::numeric_limits<double>::infinity()); }

TEST(PlaneGrid, FindsShapesFartherOutThanItsCells) { expectToFindAll(8); }

TEST(PlaneGrid, VisitsFewShapesIfMostLieElsewhere) {
  // 10 000 unit segments lie on a 100 × 100 lattice; a small query must return only its neighbourhood.
  std::vector<Triangle2> segments;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) segments.push_back({Vec2(i, j), Vec2(i + 0.5, j), Vec2(i + 0.5, j)});
  PlaneGrid grid(segments, 1000);
  EXPECT_LE(grid.near({Vec2(50.1, 50.1), Vec2(50.2, 50.1), Vec2(50.1, 50.2)}).size(), 4u);
}

TEST(PlaneGrid, EntersLongSlantedShapesAlongTheirLengthOnly) {
  std::vector<Triangle2> segments;
  for (int k = 0; k < 1000; ++k) segments.push_back({Vec2(0, k), Vec2(1000, k + 1000), Vec2(1000, k + 1000)});
  PlaneGrid grid(segments, 1e9);
  // The far corner of the box: no diagonal passes there.
  EXPECT_EQ(grid.near({Vec2(990, 5), Vec2(995, 5), Vec2(990, 10)}).size(), 0u);
}

TEST(PlaneGrid, IsEmptyWithoutShapes) {
  PlaneGrid grid({}, 10);
  EXPECT_TRUE(grid.near({Vec2(0), Vec2(1, 0), Vec2(0, 1)}).empty());
  EXPECT_FALSE(grid.anyNear({Vec2(0), Vec2(1, 0), Vec2(0, 1)}));
}

}  // namespace
}  // namespace qrelief
