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
  return enclosingShells(mesh, shells, std::vector<char>(shells.count, 1)).enclosing;
}

TEST(EnclosingShells, ListsEveryEnclosingShell) {
  const Mesh dolls =
      shapes::together(shapes::together(shapes::box({2, 2, 2}), shapes::box({6, 6, 6})), shapes::box({4, 4, 4}));
  EXPECT_EQ(nesting(dolls), (Lists{{1, 2}, {}, {1}}));
}

TEST(EnclosingShells, GivesUpOnTooManyPairsOfPointsAndTriangles) {
  Mesh dolls = shapes::icosphere(1, 3);
  for (int i = 2; i < 12; ++i) dolls = shapes::together(dolls, shapes::icosphere(i, 3));
  Adjacency adjacency = buildAdjacency(dolls.triangles);
  const Shells shells = makeConsistent(dolls.triangles, adjacency).shells;
  const std::vector<char> closed(shells.count, 1);
  EXPECT_TRUE(enclosingShells(dolls, shells, closed).known);
  const ShellNesting nesting = enclosingShells(dolls, shells, closed, 1000);
  EXPECT_FALSE(nesting.known);
  EXPECT_EQ(nesting.enclosing, Lists(11));
}

TEST(EnclosingShells, DoesNotNestABoxInTheHoleOfATorus) {
  const Mesh mesh = shapes::together(shapes::torus(10, 3, 40, 20), shapes::box({2, 2, 2}));
  EXPECT_EQ(nesting(mesh), (Lists{{}, {}}));
}

TEST(EnclosingShells, NestsABallInTheTubeOfATorus) {
  const Mesh mesh =
      shapes::together(shapes::torus(10, 3, 40, 20), shapes::translated(shapes::icosphere(1, 1), {0, 10, 0}));
  EXPECT_EQ(nesting(mesh), (Lists{{}, {0}}));
}

TEST(EnclosingShells, CountsARayThroughVerticesAndEdgesOnce) {
  // The inner boxes' centroids lie below vertices, edges and diagonals of the outer grid.
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
