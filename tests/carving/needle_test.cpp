// SPDX-License-Identifier: GPL-3.0-or-later
#include "carving/needle.h"

#include <cmath>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

/// Two facets on a long edge of the square [0, 16]², with a third facet of given height between them.
struct Scene {
  Mesh mesh;
  Footprint footprint;
};

Scene needleOfHeight(float height) {
  Scene s;
  s.mesh.positions = {{0, 0, 0}, {16, 0, 0}, {7, height, 0}, {7, -5, 0}, {7, 5, 0}};
  s.footprint.facets = {0, 1, 2, 3};
  s.footprint.vertices = {0, 1, 2, 3, 4};
  for (const Vec3f& p : s.mesh.positions) s.footprint.points.emplace_back(p.x, p.y);
  s.footprint.corners = {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {2, 1, 4}};
  return s;
}

TEST(Needle, MeasuresTheHeightOfATriangle) {
  EXPECT_DOUBLE_EQ(triangleHeight({0, 0, 0}, {5, 0, 0}, {1, 2, 0}), 2);
  EXPECT_DOUBLE_EQ(triangleHeight({0, 0, 0}, {1, 2, 0}, {5, 0, 0}), 2);
  EXPECT_EQ(triangleHeight({1, 1, 1}, {1, 1, 1}, {1, 1, 1}), 0);
}

TEST(Needle, RequiresFourUnitsInTheLastPlaceOfTheLargestCoordinate) {
  const std::vector<Vec3f> positions{{1, 2, 3}, {0, -100, 5}};
  EXPECT_DOUBLE_EQ(lowestHeight(positions), 4 * 0x1p-17);  // 64 … 128 has a spacing of 2⁻¹⁷
}

TEST(Needle, FlipsTheLongestEdgeOfANeedle) {
  Scene s = needleOfHeight(1e-6f);
  flipNeedles(s.footprint, s.mesh);
  EXPECT_EQ(s.footprint.reshaped, (std::vector<char>{1, 1, 0, 0}));
  double area = 0;
  for (const Triangle& t : s.footprint.corners) {
    EXPECT_GT(triangleHeight(s.mesh.positions[t[0]], s.mesh.positions[t[1]], s.mesh.positions[t[2]]), 1);
    const Vec2 a = s.footprint.points[t[0]];
    area += cross2(s.footprint.points[t[1]] - a, s.footprint.points[t[2]] - a) / 2;
  }
  EXPECT_NEAR(area, 16 * 5, 1e-9);
}

TEST(Needle, KeepsFacetsThatFloatsCanRepresent) {
  Scene s = needleOfHeight(1e-3f);
  const std::vector<Triangle> before = s.footprint.corners;
  flipNeedles(s.footprint, s.mesh);
  EXPECT_EQ(s.footprint.corners, before);
  EXPECT_EQ(s.footprint.reshaped, std::vector<char>(4, 0));
}

TEST(Needle, KeepsANeedleOnTheRim) {
  Scene s = needleOfHeight(1e-6f);
  s.footprint.facets.erase(s.footprint.facets.begin() + 1);
  s.footprint.corners.erase(s.footprint.corners.begin() + 1);
  const std::vector<Triangle> before = s.footprint.corners;
  flipNeedles(s.footprint, s.mesh);
  EXPECT_EQ(s.footprint.corners, before);
}

}  // namespace
}  // namespace qrelief
