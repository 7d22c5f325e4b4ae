// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/box_tree.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

#include "support/shapes.h"

namespace qrelief {
namespace {

std::vector<std::uint32_t> everySecond(const Mesh& mesh) {
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t += 2) triangles.push_back(t);
  return triangles;
}

/// Returns the triangles of the found leaves whose own boxes overlap, ascending.
std::vector<std::uint32_t> overlapping(const BoxTree& tree, const FloatBox& box) {
  std::vector<std::uint32_t> leaves;
  tree.findLeaves(box, 0, leaves);
  std::vector<std::uint32_t> found;
  for (const std::uint32_t leaf : leaves)
    for (std::size_t i = 0; i < tree.trianglesIn(leaf).size(); ++i)
      if (tree.boxesIn(leaf)[i].overlaps(box)) found.push_back(tree.trianglesIn(leaf)[i]);
  std::sort(found.begin(), found.end());
  return found;
}

TEST(BoxTree, FindsTheSameTrianglesAsBruteForce) {
  const Mesh mesh = shapes::bumpySphere(10, 2, 3, 3);
  const std::vector<std::uint32_t> triangles = everySecond(mesh);
  const BoxTree tree(mesh, triangles);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t += 7) {
    const FloatBox box = boxOfTriangle(mesh, mesh.triangles[t]);
    std::vector<std::uint32_t> expected;
    for (const std::uint32_t other : triangles)
      if (boxOfTriangle(mesh, mesh.triangles[other]).overlaps(box)) expected.push_back(other);
    EXPECT_EQ(overlapping(tree, box), expected);
  }
}

TEST(BoxTree, HoldsEachTriangleInOneLeaf) {
  const Mesh mesh = shapes::icosphere(10, 2);
  const std::vector<std::uint32_t> triangles = everySecond(mesh);
  const BoxTree tree(mesh, triangles);
  std::vector<std::uint32_t> held;
  for (std::size_t leaf = 0; leaf < tree.leafCount(); ++leaf)
    held.insert(held.end(), tree.trianglesIn(leaf).begin(), tree.trianglesIn(leaf).end());
  std::sort(held.begin(), held.end());
  EXPECT_EQ(held, triangles);
}

TEST(BoxTree, FindsLeavesInOrderFromTheGivenOne) {
  const Mesh mesh = shapes::icosphere(10, 3);
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  const BoxTree tree(mesh, all);
  std::vector<std::uint32_t> leaves;
  for (const std::size_t first : {std::size_t{0}, std::size_t{1}, tree.leafCount() / 2, tree.leafCount() - 1}) {
    tree.findLeaves(tree.bounds(), first, leaves);
    std::vector<std::uint32_t> expected(tree.leafCount() - first);
    std::iota(expected.begin(), expected.end(), static_cast<std::uint32_t>(first));
    EXPECT_EQ(leaves, expected);
  }
}

TEST(BoxTree, CountsTouchingBoxes) {
  const FloatBox a{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(a.overlaps({{1, 1, 1}, {2, 2, 2}}));
  EXPECT_FALSE(a.overlaps({{1.0000001f, 0, 0}, {2, 1, 1}}));
}

TEST(BoxTree, HandlesAllBoxesInOnePlace) {
  Mesh mesh = shapes::tetrahedron(1);
  mesh.triangles.assign(100, Triangle(mesh.triangles[0]));
  std::vector<std::uint32_t> all(100);
  std::iota(all.begin(), all.end(), 0u);
  EXPECT_EQ(overlapping(BoxTree(mesh, all), boxOfTriangle(mesh, mesh.triangles[0])), all);
}

TEST(BoxTree, OfNoTrianglesFindsNothing) {
  EXPECT_TRUE(overlapping(BoxTree(Mesh{}, {}), {{0, 0, 0}, {1, 1, 1}}).empty());
}

}  // namespace
}  // namespace qrelief
