// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/weld.h"

#include <cmath>
#include <gtest/gtest.h>

namespace qrelief {
namespace {

TEST(WeldEqual, NumbersPositionsByFirstAppearance) {
  const std::vector<Vec3f> points{{1, 2, 3}, {4, 5, 6}, {1, 2, 3}, {0, 0, 0}, {4, 5, 6}};
  const Welding welding = weldEqual(points);
  EXPECT_EQ(welding.positions, (std::vector<Vec3f>{{1, 2, 3}, {4, 5, 6}, {0, 0, 0}}));
  EXPECT_EQ(welding.indexOf, (std::vector<std::uint32_t>{0, 1, 0, 2, 1}));
}

TEST(WeldEqual, TreatsMinusZeroAsZero) {
  const Welding welding = weldEqual(std::vector<Vec3f>{{-0.0f, 1, 0}, {0, 1, -0.0f}});
  ASSERT_EQ(welding.positions.size(), 1u);
  EXPECT_FALSE(std::signbit(welding.positions[0].x));
}

TEST(WeldEqual, DistinguishesNeighbouringFloats) {
  const std::vector<Vec3f> points{{1, 0, 0}, {std::nextafter(1.0f, 2.0f), 0, 0}};
  EXPECT_EQ(weldEqual(points).positions.size(), 2u);
}

TEST(WeldEqual, FindsEveryPointOfALargeGridAgain) {
  std::vector<Vec3f> points;
  for (int round = 0; round < 2; ++round)
    for (int i = 0; i < 40'000; ++i) points.emplace_back(i % 200, i / 200, 0.25f);
  const Welding welding = weldEqual(points);
  ASSERT_EQ(welding.positions.size(), 40'000u);
  for (std::uint32_t i = 0; i < points.size(); ++i) EXPECT_EQ(welding.indexOf[i], i % 40'000);
}

TEST(WeldEqual, AcceptsAnEmptyList) { EXPECT_TRUE(weldEqual({}).positions.empty()); }

TEST(DropUnused, KeepsTheOrderOfUsedVertices) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  mesh.triangles = {{4, 1, 3}};
  dropUnused(mesh);
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{1, 0, 0}, {3, 0, 0}, {4, 0, 0}}));
  EXPECT_EQ(mesh.triangles[0], (Triangle{2, 0, 1}));
}

}  // namespace
}  // namespace qrelief
