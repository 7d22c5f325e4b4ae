// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/topology.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>

#include "support/shapes.h"

namespace qrelief {
namespace {

TEST(EdgeTable, GroupsLikeAMapOverAllEdges) {
  Mesh mesh = shapes::together(shapes::torus(10, 3, 7, 5), shapes::box({1, 1, 1}));
  mesh.triangles.push_back(mesh.triangles[3]);       // a doubled triangle
  mesh.triangles.erase(mesh.triangles.begin() + 8);  // and a hole
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> expected;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      expected[{low, high}].push_back(3 * t + k);
    }
  const EdgeTable table = buildEdgeTable(mesh.triangles);
  ASSERT_EQ(table.size(), expected.size());
  std::size_t e = 0;
  for (const auto& [edge, halfEdges] : expected) {
    const auto found = table.at(e++);
    EXPECT_EQ(std::vector(found.begin(), found.end()), halfEdges);
  }
}

TEST(EdgeTable, OfNoTrianglesIsEmpty) { EXPECT_EQ(buildEdgeTable({}).size(), 0u); }

TEST(EdgeTable, ObeysEulersFormula) {
  const Mesh sphere = shapes::icosphere(1, 2);
  EXPECT_EQ(sphere.positions.size() + sphere.triangles.size() - buildEdgeTable(sphere.triangles).size(), 2u);
  const Mesh torus = shapes::torus(10, 3, 9, 8);
  EXPECT_EQ(torus.positions.size() + torus.triangles.size() - buildEdgeTable(torus.triangles).size(), 0u);
}

TEST(Adjacency, IsMutualAcrossTheSameEdge) {
  const Mesh mesh = shapes::icosphere(1, 3);
  const Adjacency adjacency = buildAdjacency(mesh.triangles);
  for (std::uint32_t t = 0; t < adjacency.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t n = adjacency[t][k];
      ASSERT_NE(n, kNoTriangle);
      const auto j = static_cast<std::size_t>(sharedEdge(adjacency, n, t));
      EXPECT_EQ(mesh.triangles[n][j], mesh.triangles[t][(k + 1) % 3]);
      EXPECT_EQ(mesh.triangles[n][(j + 1) % 3], mesh.triangles[t][k]);
    }
}

TEST(Adjacency, HasNoTriangleAcrossOpenAndNonManifoldEdges) {
  const std::vector<Triangle> fan{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};  // three triangles on one edge, all others open
  for (const auto& neighbours : buildAdjacency(fan))
    for (const std::uint32_t n : neighbours) EXPECT_EQ(n, kNoTriangle);
}

}  // namespace
}  // namespace qrelief
