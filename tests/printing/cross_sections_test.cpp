// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/cross_sections.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <utility>

#include "support/shapes.h"

namespace qrelief {
namespace {

CrossSections cut(const Mesh& mesh, const CuttingPlanes& planes, Vec2 low, Vec2 high) {
  const std::vector<Vec3> positions(mesh.positions.begin(), mesh.positions.end());
  return cutByPlanes(positions, mesh.triangles, planes, low, high);
}

/// Returns the enclosed area; positive if the solid lies on the left.
double enclosedArea(const std::vector<Segment2>& outline) {
  double area = 0;
  for (const auto& [a, b] : outline) area += cross2(a, b) / 2;
  return area;
}

/// Expects that every segment begins where another ends.
void expectClosed(const std::vector<Segment2>& outline) {
  std::map<std::pair<double, double>, int> balance;
  for (const auto& [a, b] : outline) {
    ++balance[{a.x, a.y}];
    --balance[{b.x, b.y}];
  }
  for (const auto& [point, count] : balance) EXPECT_EQ(count, 0) << point.first << ", " << point.second;
}

TEST(CuttingPlanes, FindTheFirstAboveAHeight) {
  const CuttingPlanes planes{0.1, 0.2, 50};
  EXPECT_EQ(planes.firstAbove(-1e9), 0);
  EXPECT_EQ(planes.firstAbove(0.09), 0);
  EXPECT_EQ(planes.firstAbove(1e9), 50);
  for (int k = 0; k < planes.count; ++k) {
    const double height = planes.heightMm(k);
    EXPECT_EQ(planes.firstAbove(std::nextafter(height, -1)), k);
    EXPECT_EQ(planes.firstAbove(height), k + 1) << "a vertex in a plane counts as above it";
  }
}

TEST(CrossSections, OfASphereAreCircles) {
  const double radius = 10;
  const CuttingPlanes planes{-9.5, 1, 20};
  const CrossSections sections = cut(shapes::icosphere(radius, 5), planes, Vec2(-20.1), Vec2(20));
  for (int k = 0; k < planes.count; ++k) {
    const double height = planes.heightMm(k);
    const double expected = std::numbers::pi * (radius * radius - height * height);
    EXPECT_NEAR(enclosedArea(sections.outlines[static_cast<std::size_t>(k)]), expected, 0.003 * std::numbers::pi * 100);
    expectClosed(sections.outlines[static_cast<std::size_t>(k)]);
    EXPECT_EQ(sections.windings[static_cast<std::size_t>(k)], 0);
  }
}

TEST(CrossSections, APlaneThroughVerticesAndFacetsCutsJustBelowThem) {
  // The planes pass through bottom, middle and top of a box; the bottom plane has nothing below it.
  const CrossSections sections = cut(shapes::box({4, 6, 2}), {-1, 1, 3}, Vec2(-9.1), Vec2(9));
  EXPECT_EQ(sections.outlines[0].size(), 0u);
  EXPECT_NEAR(enclosedArea(sections.outlines[1]), 24, 1e-9);
  EXPECT_NEAR(enclosedArea(sections.outlines[2]), 24, 1e-9);
}

TEST(CrossSections, SubtractsCavitiesAndCountsTheWindingAtTheCorner) {
  const Mesh hollow = shapes::together(shapes::box({10, 10, 10}), shapes::insideOut(shapes::box({4, 4, 4})));
  const CuttingPlanes planes{-6.5, 1, 14};
  const CrossSections within = cut(hollow, planes, Vec2(0.1, 0.2), Vec2(9));
  const CrossSections all = cut(hollow, planes, Vec2(-9.1), Vec2(9));
  for (int k = 0; k < planes.count; ++k) {
    const double height = std::abs(planes.heightMm(k));
    EXPECT_EQ(within.windings[static_cast<std::size_t>(k)], height < 5 && height > 2 ? 1 : 0) << height;
    EXPECT_NEAR(enclosedArea(all.outlines[static_cast<std::size_t>(k)]), height < 2 ? 84 : height < 5 ? 100 : 0, 1e-9);
  }
}

TEST(CrossSections, OmitsEverythingOutsideTheRectangle) {
  const Mesh two = shapes::together(shapes::box({2, 2, 2}), shapes::translated(shapes::box({2, 2, 2}), {10, 0, 0}));
  const CrossSections sections = cut(two, {0, 1, 1}, Vec2(-3.1), Vec2(3));
  EXPECT_NEAR(enclosedArea(sections.outlines[0]), 4, 1e-9);
}

}  // namespace
}  // namespace qrelief
