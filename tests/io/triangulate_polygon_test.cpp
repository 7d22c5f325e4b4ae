// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/triangulate_polygon.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

namespace qrelief {
namespace {

double area(const std::vector<Vec3>& p, const std::array<std::uint32_t, 3>& t, Vec3 normal) {
  return glm::dot(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]), normal) / 2;
}

/// Expects that all triangles face along the normal, that none overlap (their areas sum to the polygon's area), and
/// that the border is the outline.
void expectCovers(const std::vector<Vec3>& polygon, Vec3 normal, double wantedArea) {
  const PolygonTriangles cut = triangulatePolygon(polygon);
  EXPECT_TRUE(cut.simple);
  ASSERT_EQ(cut.triangles.size(), polygon.size() - 2);
  double sum = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> border;
  for (const auto& t : cut.triangles) {
    EXPECT_GT(area(polygon, t, normal), 0);
    sum += area(polygon, t, normal);
    for (std::size_t k = 0; k < 3; ++k) {
      ++border[{t[k], t[(k + 1) % 3]}];
      --border[{t[(k + 1) % 3], t[k]}];
    }
  }
  EXPECT_NEAR(sum, wantedArea, 1e-12 * wantedArea);
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (const auto& [edge, count] : border)
    EXPECT_EQ(count, (edge.first + 1) % n == edge.second ? 1 : (edge.second + 1) % n == edge.first ? -1 : 0);
}

const Vec3 kUp(0, 0, 1);

TEST(TriangulatePolygon, FansAConvexPolygon) {
  std::vector<Vec3> polygon;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2 * std::numbers::pi * i / 12;
    polygon.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  expectCovers(polygon, kUp, 3);
}

TEST(TriangulatePolygon, KeepsTheWindingInAnyPlane) {
  const std::vector<Vec3> onX = {{5, 0, 0}, {5, 0, 2}, {5, 3, 2}, {5, 3, 0}};
  expectCovers(onX, Vec3(-1, 0, 0), 6);
}

TEST(TriangulatePolygon, SplitsAQuadrilateralAlongItsShorterDiagonal) {
  const PolygonTriangles cut = triangulatePolygon(std::vector<Vec3>{{-3, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}});
  ASSERT_EQ(cut.triangles.size(), 2u);
  EXPECT_EQ(cut.triangles[0], (std::array<std::uint32_t, 3>{1, 2, 3}));
  EXPECT_EQ(cut.triangles[1], (std::array<std::uint32_t, 3>{1, 3, 0}));
}

TEST(TriangulatePolygon, SplitsAConcaveQuadrilateralInside) {
  expectCovers({{0, 0, 0}, {4, -1, 0}, {1, 0, 0}, {4, 1, 0}}, kUp, 1);
}

TEST(TriangulatePolygon, TriangulatesAConcaveLetter) {
  expectCovers({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {3, 2, 0}, {3, 3, 0}, {0, 3, 0}}, kUp, 7);
}

TEST(TriangulatePolygon, LeavesNoTriangleWithoutAreaAtStraightCorners) {
  expectCovers({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}}, kUp, 4);
  expectCovers({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, kUp, 1);
}

TEST(TriangulatePolygon, TriangulatesARingJoinedByADoubledEdge) {
  // A 4 x 4 square has a 2 x 2 hole; the outline enters and leaves it along the edge from (0, 0) to (1, 1).
  expectCovers(
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}},
      kUp, 12);
}

TEST(TriangulatePolygon, TriangulatesAStarWithManyReflexCorners) {
  std::vector<Vec3> polygon;
  for (int i = 0; i < 400; ++i) {
    const double angle = 2 * std::numbers::pi * i / 400;
    polygon.push_back(Vec3(std::cos(angle), std::sin(angle), 0) * (i % 2 ? 1.0 : 0.5));
  }
  expectCovers(polygon, kUp, 400 * 0.5 * 0.5 * std::sin(2 * std::numbers::pi / 400));
}

TEST(TriangulatePolygon, ReportsASelfCrossingPolygon) {
  const PolygonTriangles cut =
      triangulatePolygon(std::vector<Vec3>{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 3, 0}, {-1, 1, 0}});
  EXPECT_FALSE(cut.simple);
  EXPECT_EQ(cut.triangles.size(), 3u);
}

TEST(TriangulatePolygon, ReportsAPolygonWithoutArea) {
  EXPECT_FALSE(triangulatePolygon(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).simple);
}

std::vector<Vec3> starOf(int corners, double innerRadius) {
  std::vector<Vec3> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    polygon.push_back(Vec3(std::cos(angle), std::sin(angle), 0) * (i % 2 ? 1.0 : innerRadius));
  }
  return polygon;
}

/// Returns a saw with teeth of pseudo-random height below a flat top.
std::vector<Vec3> sawOf(int corners) {
  std::vector<Vec3> polygon;
  for (int i = 0; i < corners - 2; ++i) polygon.emplace_back(100.0 * i / corners, i * 7919 % 1009 * 0.02, 0);
  polygon.emplace_back(101, 50, 0);
  polygon.emplace_back(-1, 50, 0);
  return polygon;
}

std::vector<Vec3> spiralOf(int corners) {
  std::vector<Vec3> polygon, inner;
  for (int i = 0; i < corners / 2; ++i) {
    const double angle = 16 * std::numbers::pi * std::sqrt((i + 1.0) / (corners / 2));
    polygon.push_back(Vec3(std::cos(angle), std::sin(angle), 0) * (angle + std::numbers::pi));
    inner.push_back(Vec3(std::cos(angle), std::sin(angle), 0) * angle);
  }
  std::reverse(inner.begin(), inner.end());
  polygon.insert(polygon.end(), inner.begin(), inner.end());
  return polygon;
}

std::size_t testsPerCorner(const std::vector<Vec3>& polygon) {
  const PolygonTriangles cut = triangulatePolygon(polygon);
  EXPECT_TRUE(cut.simple);
  EXPECT_EQ(cut.triangles.size(), polygon.size() - 2);
  return cut.tests / polygon.size();
}

TEST(TriangulatePolygon, TakesFewTestsPerCornerForAnyNumberOfCorners) {
  for (const int corners : {4000, 64'000}) {
    EXPECT_LE(testsPerCorner(starOf(corners, 0.5)), 40u) << corners;
    EXPECT_LE(testsPerCorner(sawOf(corners)), 100u) << corners;
    EXPECT_LE(testsPerCorner(spiralOf(corners)), 400u) << corners;
  }
}

TEST(TriangulatePolygon, FansALargeConvexPolygon) {
  // Ears cut from three adjacent corners would be flatter than floats can resolve.
  const PolygonTriangles cut = triangulatePolygon(starOf(20'000, 1));
  EXPECT_TRUE(cut.simple);
  EXPECT_EQ(cut.tests, 0u);
  for (const auto& t : cut.triangles) ASSERT_EQ(t[0], 0u);
}

TEST(TriangulatePolygon, TriangulatesVeryAcuteSpikes) {
  // The tips turn by nearly half a turn, whose sine is small as well.
  std::vector<Vec3> polygon;
  for (int i = 0; i < 20; ++i) {
    polygon.emplace_back(100, 2e-6 * (2 * i + 1), 0);
    polygon.emplace_back(0, 2e-6 * (2 * i + 2), 0);
  }
  polygon.emplace_back(-1, 1, 0);
  polygon.emplace_back(-1, -1, 0);
  EXPECT_TRUE(triangulatePolygon(polygon).simple);
}

std::size_t turnedOrFlat(const std::vector<Vec3>& polygon) {
  const auto triangles = triangulatePolygon(polygon).triangles;
  return static_cast<std::size_t>(
      std::count_if(triangles.begin(), triangles.end(), [&](const auto& t) { return area(polygon, t, kUp) <= 0; }));
}

TEST(TriangulatePolygon, SpoilsOneTriangleWhereAnOutlineTouchesItself) {
  std::vector<Vec3> polygon = starOf(2000, 0.5);
  polygon[1000] = polygon[1];
  EXPECT_FALSE(triangulatePolygon(polygon).simple);
  EXPECT_EQ(turnedOrFlat(polygon), 1u);
}

TEST(TriangulatePolygon, SpoilsFewTrianglesWhereCornersAreGivenTwice) {
  std::vector<Vec3> polygon;
  for (const Vec3& corner : starOf(2000, 0.5)) polygon.insert(polygon.end(), polygon.size() % 11 == 9 ? 2 : 1, corner);
  EXPECT_EQ(polygon.size(), 2200u);
  EXPECT_LE(turnedOrFlat(polygon), 201u);  // each second copy has a triangle without area
}

TEST(TriangulatePolygon, GivesUpOnAHostileOutline) {
  // A spiral crosses itself everywhere: it has no ears, and all its corners are reflex one way or the other.
  std::vector<Vec3> polygon;
  for (int i = 0; i < 20'000; ++i)
    polygon.push_back(Vec3(std::cos(2.4 * i), std::sin(2.4 * i), 0) * (1 + 0.001 * (i % 977)));
  const PolygonTriangles cut = triangulatePolygon(polygon);
  EXPECT_FALSE(cut.simple);
  EXPECT_EQ(cut.triangles.size(), polygon.size() - 2);
  EXPECT_LE(cut.tests, 300 * polygon.size());
}

}  // namespace
}  // namespace qrelief
