// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/footprint.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

#include "support/shapes.h"

namespace qrelief {
namespace {

const ProjectionFrame kFrame = makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 250);

/// Returns the facets of the upper face of a plate of n × n squares.
std::vector<std::uint32_t> upperFace(int n) {
  std::vector<std::uint32_t> patch(static_cast<std::size_t>(2 * n * n));
  std::iota(patch.begin(), patch.end(), 0u);
  return patch;
}

/// Returns 4 × 4 submodules of 5 mm of which only (1, 2) is carved: [0, 5] × [0, 5] in plane coordinates.
DepthLevels oneCarved() {
  DepthLevels levels{4, 20, std::vector<int>(16, 0)};
  levels.level[1 * 4 + 2] = 7;
  return levels;
}

TEST(Footprint, ContainsTheFacetsThatMeetACarvedSubmodule) {
  // The squares are 2 mm wide, from -20 to 20. The 4 × 4 squares from [-2, 0] to [4, 6] come within 0.4 mm of [0, 5].
  const Mesh mesh = shapes::plate({40, 40}, 5, 20, 20);
  const auto footprint = findFootprint(mesh, kFrame, upperFace(20), oneCarved(), 0.4);
  ASSERT_TRUE(footprint);
  for (const std::uint32_t f : footprint->facets)
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = mesh.corner(f, k);
      EXPECT_TRUE(p.x >= -2 && p.y >= -2 && p.x <= 6 && p.y <= 6);
    }
  // In the squares at two opposite corners, one of the two triangles stays farther away.
  EXPECT_EQ(footprint->facets.size(), 30u);
  EXPECT_TRUE(std::is_sorted(footprint->facets.begin(), footprint->facets.end()));
}

TEST(Footprint, HasItsEdgesWithTheirAdjacentFacets) {
  const Mesh mesh = shapes::plate({40, 40}, 5, 20, 20);
  const auto footprint = findFootprint(mesh, kFrame, upperFace(20), oneCarved(), 0.4);
  ASSERT_TRUE(footprint);
  std::size_t sides = 0;
  for (const Footprint::Edge& e : footprint->edges) {
    ASSERT_NE(e.left, kNoFacet);
    sides += e.right == kNoFacet ? 1 : 2;
    const Triangle& left = footprint->corners[e.left];
    const std::uint32_t apex = left[0] + left[1] + left[2] - e.a - e.b;
    EXPECT_GT(cross2(footprint->points[e.b] - footprint->points[e.a], footprint->points[apex] - footprint->points[e.a]),
              0);
  }
  EXPECT_EQ(sides, 3 * footprint->facets.size());
  // A disc: V - E + F = 1.
  EXPECT_EQ(footprint->points.size() + footprint->facets.size(), footprint->edges.size() + 1);
}

TEST(Footprint, ContainsAFacetLargerThanTheCode) {
  const Mesh mesh = shapes::plate({400, 400}, 5, 1, 1);
  DepthLevels levels = oneCarved();
  std::swap(levels.level[1 * 4 + 2], levels.level[2 * 4 + 3]);  // wholly on one side of the plate's diagonal
  const auto footprint = findFootprint(mesh, kFrame, upperFace(1), levels, 0.5);
  ASSERT_TRUE(footprint);
  EXPECT_EQ(footprint->facets.size(), 1u);
}

TEST(Footprint, IsEmptyAwayFromThePatch) {
  const Mesh mesh = shapes::translated(shapes::plate({40, 40}, 5, 2, 2), {100, 0, 0});
  const auto footprint = findFootprint(mesh, kFrame, upperFace(2), oneCarved(), 0.4);
  ASSERT_TRUE(footprint);
  EXPECT_TRUE(footprint->facets.empty());
}

}  // namespace
}  // namespace qrelief
