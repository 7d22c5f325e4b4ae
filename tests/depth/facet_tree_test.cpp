// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/facet_tree.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "base/random.h"
#include "support/brute_force.h"

namespace qrelief {
namespace {

const FacetTree::Facet kFacet{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 3, 0)};

FacetTree treeOf(const std::vector<FacetTree::Facet>& facets) { return FacetTree(facets); }

double distance(const FacetTree& tree, Vec3 point, double reach) {
  FacetTree::Hint none;
  return tree.distance(point, reach, none);
}

TEST(FacetTree, MeasuresDistancesToInteriorSideAndCornerOfAFacet) {
  const FacetTree tree = treeOf({kFacet});
  EXPECT_DOUBLE_EQ(distance(tree, {1, 1, 5}, 100), 5);
  EXPECT_DOUBLE_EQ(distance(tree, {1, 1, -5}, 100), 5);
  EXPECT_DOUBLE_EQ(distance(tree, {2, -3, 4}, 100), 5);
  EXPECT_DOUBLE_EQ(distance(tree, {2 + 3, 1.5 + 4, 0}, 100), 5) << "off the slanted side, along its normal (3, 4)";
  EXPECT_DOUBLE_EQ(distance(tree, {-2, -3, 6}, 100), 7);
  EXPECT_DOUBLE_EQ(distance(tree, {1, 1, 0}, 100), 0);
}

TEST(FacetTree, ReturnsItsReachIfNothingIsNearer) {
  const FacetTree tree = treeOf({kFacet});
  EXPECT_EQ(distance(tree, {1, 1, 5}, 4.5), 4.5);
  EXPECT_EQ(distance(treeOf({}), {1, 1, 5}, 4.5), 4.5);
}

TEST(FacetTree, TreatsAFacetWithoutAreaAsASegmentOrAPoint) {
  EXPECT_DOUBLE_EQ(distance(treeOf({{Vec3(0), Vec3(10, 0, 0), Vec3(5, 0, 0)}}), {7, 3, 4}, 100), 5);
  EXPECT_DOUBLE_EQ(distance(treeOf({{Vec3(1), Vec3(1), Vec3(1)}}), {1, 4, 5}, 100), 5);
}

TEST(FacetTree, AgreesWithBruteForceOverAllFacets) {
  Random random(9);
  const auto point = [&](double extent) {
    return Vec3(random.uniform(-extent, extent), random.uniform(-extent, extent), random.uniform(-extent, extent));
  };
  std::vector<FacetTree::Facet> facets;
  for (int k = 0; k < 700; ++k) {
    const Vec3 a = point(20);
    const double size = k % 10 == 0 ? 15 : 1;
    facets.push_back({a, a + point(size), a + point(size)});
  }
  const FacetTree tree(facets);
  FacetTree::Hint hint;
  for (int k = 0; k < 500; ++k) {
    const Vec3 query = point(25);
    double expected = 6;
    for (const FacetTree::Facet& f : facets)
      expected = std::min(expected, brute_force::distanceToFacet(query, f[0], f[1], f[2]));
    ASSERT_NEAR(distance(tree, query, 6), expected, 1e-9);
    ASSERT_EQ(tree.distance(query, 6, hint), distance(tree, query, 6)) << "whatever the last query found";
  }
}

}  // namespace
}  // namespace qrelief
