// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/weld.h"

#include <cmath>
#include <gtest/gtest.h>

#include "io/read_model.h"
#include "io/write_stl.h"
#include "mesh/topology.h"
#include "support/shapes.h"

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

TEST(WeldByPiece, GivesTheMeshOfAFileThatIsReadAgainPieceByPiece) {
  // Two boxes touch in a face. One corner of the first has two vertices, whose zeros differ in sign.
  const Mesh box = shapes::translated(shapes::box({2, 2, 2}), {1, 1, 1});
  Mesh mesh = shapes::together(box, shapes::translated(box, {2, 0, 0}));
  const Triangle first = mesh.triangles.front();
  mesh.positions.push_back(mesh.positions[first[0]]);
  for (int k = 0; k < 3; ++k)
    if (mesh.positions.back()[k] == 0) mesh.positions.back()[k] = -0.0f;
  mesh.triangles.front()[0] = static_cast<std::uint32_t>(mesh.positions.size() - 1);

  const auto read = readModel(writeStl(mesh), "written.stl");
  ASSERT_TRUE(read.has_value());
  const std::vector<std::uint32_t> pieceOf = piecesOf(mesh);
  std::vector<Vec3f> corners;
  std::vector<std::uint32_t> pieces;
  for (std::size_t t = 0; t < read->triangles.size(); ++t) {
    for (const std::uint32_t v : read->triangles[t]) corners.emplace_back(read->positions[v]);
    pieces.push_back(pieceOf[mesh.triangles[t][0]]);
  }
  const Mesh expected = weldedByGroup(corners, pieces), result = weldedByPiece(mesh);
  EXPECT_EQ(result.positions, expected.positions);
  EXPECT_EQ(result.triangles, expected.triangles);
  EXPECT_EQ(result.positions.size(), 16u) << "the boxes stay apart";
}

}  // namespace
}  // namespace qrelief
