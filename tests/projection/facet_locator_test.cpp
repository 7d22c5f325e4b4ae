// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/facet_locator.h"

#include <cmath>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

/// Returns a fan of eight facets about the origin.
FacetLocator fan() {
  std::vector<Triangle2> images;
  const std::vector<Vec2> rim{{3, 0}, {2, 2}, {0, 3}, {-2, 2}, {-3, 0}, {-2, -2}, {0, -3}, {2, -2}};
  for (std::size_t k = 0; k < rim.size(); ++k) images.push_back({Vec2(0), rim[k], rim[(k + 1) % rim.size()]});
  return FacetLocator(images);
}

TEST(FacetLocator, FindsTheFacetThatContainsAPoint) {
  FacetLocator locator = fan();
  for (std::uint32_t k = 0; k < 8; ++k) {
    const double angle = (k + 0.5) * 0.78539816339744831;
    EXPECT_EQ(locator.nearest(Vec2(std::cos(angle), std::sin(angle)) * 1.5), k);
  }
}

TEST(FacetLocator, ReturnsTheLowestFacetOnACommonBorder) {
  FacetLocator locator = fan();
  EXPECT_EQ(locator.nearest({0, 0}), 0u);
  EXPECT_EQ(locator.nearest({0, 1.5}), 1u);
}

TEST(FacetLocator, ToleratesAPointThatRoundingPutsOutsideEveryFacet) {
  FacetLocator locator({{Vec2(0, 0), Vec2(4, 0), Vec2(0, 3)}, {Vec2(0, -3), Vec2(4, -2e-12), Vec2(0, -2e-12)}});
  EXPECT_EQ(locator.nearest({1, -0.5e-12}), 0u);
  EXPECT_EQ(locator.nearest({1, -1.5e-12}), 1u);
}

TEST(FacetLocator, MeasuresDepthFromTheNearestSide) {
  const FacetLocator locator(std::vector<Triangle2>{{Vec2(0, 0), Vec2(4, 0), Vec2(0, 3)}});
  EXPECT_DOUBLE_EQ(locator.depthIn(0, {1, 1}), 1);
  EXPECT_DOUBLE_EQ(locator.depthIn(0, {1, -0.25}), -0.25);
  EXPECT_NEAR(locator.depthIn(0, {4, 3}), -12.0 / 5, 1e-15);
}

}  // namespace
}  // namespace qrelief
