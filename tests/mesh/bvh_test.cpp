// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/bvh.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

#include "base/random.h"

namespace qrelief {
namespace {

std::vector<Bvh::Box> randomBoxes(int count) {
  Random random(4);
  std::vector<Bvh::Box> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3f min(random.uniform(0, 50), random.uniform(0, 50), random.uniform(0, 50));
    boxes.push_back({min, min + Vec3f(random.uniform(0, 2), random.uniform(0, 2), random.uniform(0, 2))});
  }
  return boxes;
}

bool holds(const Bvh::Box& outer, const Bvh::Box& inner) {
  return glm::min(outer.min, inner.min) == outer.min && glm::max(outer.max, inner.max) == outer.max;
}

bool holdsPoint(const Bvh::Box& box, Vec3f p) { return holds(box, {p, p}); }

/// Returns the indices of the boxes that hold the point, from the leaves visited for it, ascending.
std::vector<std::uint32_t> found(const Bvh& tree, std::span<const Bvh::Box> boxes, Vec3f point, bool firstIsNearer) {
  std::vector<std::uint32_t> hits;
  tree.visit([&](std::uint32_t node) { return holdsPoint(tree.nodes()[node].box, point); },
             [&](std::uint32_t, std::uint32_t) { return firstIsNearer; },
             [&](std::uint32_t begin, std::uint32_t end) {
               for (std::uint32_t i = begin; i < end; ++i)
                 if (holdsPoint(boxes[tree.order()[i]], point)) hits.push_back(tree.order()[i]);
             });
  std::sort(hits.begin(), hits.end());
  return hits;
}

TEST(Bvh, HoldsEachBoxInOneLeaf) {
  const std::vector<Bvh::Box> boxes = randomBoxes(1000);
  const Bvh tree(boxes);
  std::vector<std::uint32_t> order(tree.order().begin(), tree.order().end()), all(boxes.size());
  std::iota(all.begin(), all.end(), 0u);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, all);
}

TEST(Bvh, NodesEncloseTheirChildren) {
  const std::vector<Bvh::Box> boxes = randomBoxes(1000);
  const Bvh tree(boxes);
  for (std::uint32_t i = 0; i < tree.nodes().size(); ++i) {
    const Bvh::Node& node = tree.nodes()[i];
    for (std::uint32_t k = 0; k < node.count; ++k) EXPECT_TRUE(holds(node.box, boxes[tree.order()[node.begin + k]]));
    if (node.count > 0) continue;
    EXPECT_GT(node.begin, i + 1);
    EXPECT_TRUE(holds(node.box, tree.nodes()[i + 1].box) && holds(node.box, tree.nodes()[node.begin].box));
  }
}

TEST(Bvh, VisitsAcceptedLeavesInEitherOrder) {
  const std::vector<Bvh::Box> boxes = randomBoxes(2000);
  const Bvh tree(boxes);
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3f point(random.uniform(0, 50), random.uniform(0, 50), random.uniform(0, 50));
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < boxes.size(); ++k)
      if (holdsPoint(boxes[k], point)) expected.push_back(k);
    EXPECT_EQ(found(tree, boxes, point, true), expected);
    EXPECT_EQ(found(tree, boxes, point, false), expected);
  }
}

TEST(Bvh, HandlesBoxesInOnePlaceAndNoBoxes) {
  const std::vector<Bvh::Box> same(50, Bvh::Box{Vec3f(1), Vec3f(2)});
  EXPECT_EQ(found(Bvh(same), same, Vec3f(1.5f), true).size(), 50u);
  EXPECT_TRUE(Bvh({}).nodes().empty());
  EXPECT_TRUE(found(Bvh({}), {}, Vec3f(0), true).empty());
}

}  // namespace
}  // namespace qrelief
