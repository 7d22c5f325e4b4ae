// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/shell_nesting.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

using Lists = std::vector<std::vector<std::uint32_t>>;

Lists nesting(const Mesh& mesh) {
  std::vector<Triangle> triangles = mesh.triangles;
  Adjacency adjacency = buildAdjacency(triangles);
  const Shells shells = makeConsistent(triangles, adjacency).shells;
  return enclosingShells(mesh, shells, std::vector<char>(shells.count, 1));
}

TEST(EnclosingShells, ListsEveryShellAround) {
  const Mesh dolls =
      shapes::together(shapes::together(shapes::box({2, 2, 2}), shapes::box({6, 6, 6})), shapes::box({4, 4, 4}));
  EXPECT_EQ(nesting(dolls), (Lists{{1, 2}, {}, {1}}));
}

TEST(EnclosingShells, IsNotDeceivedByABoxInTheHoleOfATorus) {
  const Mesh mesh = shapes::together(shapes::torus(10, 3, 40, 20), shapes::box({2, 2, 2}));
  EXPECT_EQ(nesting(mesh), (Lists{{}, {}}));
}

TEST(EnclosingShells, FindsABallInTheTubeOfATorus) {
  const Mesh mesh =
      shapes::together(shapes::torus(10, 3, 40, 20), shapes::translated(shapes::icosphere(1, 1), {0, 10, 0}));
  EXPECT_EQ(nesting(mesh), (Lists{{}, {0}}));
}

TEST(EnclosingShells, CountsARayThroughVerticesAndEdgesOnce) {
  // The inner boxes' centroids stand under vertices, edges and diagonals of the outer grid.
  Mesh mesh = shapes::plate({12, 12}, 6, 12, 12);
  for (int i = -4; i <= 4; ++i)
    mesh = shapes::together(mesh, shapes::translated(shapes::box({0.75, 0.75, 0.75}), {i, -i, -3}));
  const Lists lists = nesting(mesh);
  EXPECT_TRUE(lists[0].empty());
  for (std::size_t s = 1; s < lists.size(); ++s) EXPECT_EQ(lists[s], (std::vector<std::uint32_t>{0}));
}

TEST(EnclosingShells, SeparatesShellsSideBySide) {
  EXPECT_EQ(nesting(shapes::together(shapes::box({2, 2, 2}), shapes::translated(shapes::box({1, 1, 1}), {5, 0, 0}))),
            (Lists{{}, {}}));
}

}  // namespace
}  // namespace qrelief
