// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/box_tree.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

TEST(BoxTree, FindsWhatBruteForceFinds) {
  const Mesh mesh = shapes::bumpySphere(10, 2, 3, 3);
  const BoxTree tree(mesh);
  std::vector<std::uint32_t> found;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t += 7) {
    tree.findOverlaps(tree.boxOf(t), found);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t other = 0; other < mesh.triangles.size(); ++other)
      if (tree.boxOf(other).overlaps(tree.boxOf(t))) expected.push_back(other);
    EXPECT_EQ(found, expected);
  }
}

TEST(BoxTree, CountsTouchingBoxes) {
  const FloatBox a{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(a.overlaps({{1, 1, 1}, {2, 2, 2}}));
  EXPECT_FALSE(a.overlaps({{1.0000001f, 0, 0}, {2, 1, 1}}));
}

TEST(BoxTree, CopesWithAllBoxesInOnePlace) {
  Mesh mesh = shapes::tetrahedron(1);
  const Triangle first = mesh.triangles[0];
  mesh.triangles.assign(100, first);
  const BoxTree tree(mesh);
  std::vector<std::uint32_t> found;
  tree.findOverlaps(tree.boxOf(0), found);
  EXPECT_EQ(found.size(), 100u);
}

TEST(BoxTree, OfAnEmptyMeshFindsNothing) {
  std::vector<std::uint32_t> found;
  BoxTree(Mesh{}).findOverlaps({{0, 0, 0}, {1, 1, 1}}, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace qrelief
