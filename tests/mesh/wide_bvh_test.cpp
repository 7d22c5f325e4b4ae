// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wide_bvh.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

#include "base/random.h"

namespace qrelief {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// Returns boxes, some of them flat or a line, at some distance from the origin.
std::vector<Bvh::Box> randomBoxes(int count, float away) {
  Random random(11);
  std::vector<Bvh::Box> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec3f min(away + random.uniform(0, 50), random.uniform(0, 50), random.uniform(0, 50));
    const Vec3f size(random.uniform(0, 2), i % 3 ? random.uniform(0, 2) : 0, i % 5 ? random.uniform(0, 2) : 0);
    boxes.push_back({min, min + size});
  }
  return boxes;
}

/// Counts how often each box is in a visited leaf.
std::vector<int> visits(const Bvh& tree, const WideBvh& wide, Vec3 origin, Vec3 direction, double from,
                        double nearest) {
  std::vector<int> times(tree.order().size(), 0);
  wide.visit(origin, direction, from, nearest, [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) ++times[tree.order()[i]];
  });
  return times;
}

Vec3 within(const Bvh::Box& box, Random& random) {
  Vec3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = random.uniform(box.min[axis], box.max[axis]);
  return p;
}

TEST(WideBvh, VisitsEveryBoxWithAPointOfTheRayOnce) {
  for (const float away : {0.0f, 3e4f}) {
    const std::vector<Bvh::Box> boxes = randomBoxes(1500, away);
    const Bvh tree(boxes);
    const WideBvh wide(tree);
    Random random(12);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      const Vec3 target = within(boxes[i], random);
      Vec3 direction(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      if (i % 4 == 0) direction[static_cast<int>(i / 4 % 3)] = 0;  // parallel to sides of all boxes
      if (i % 7 == 0) direction = Vec3(0, 0, i % 2 ? 1 : -1);
      const Vec3 origin = target - direction * (i % 9 == 0 ? 0.0 : 60.0);
      const std::vector<int> times = visits(tree, wide, origin, direction, 0, kEndless);
      EXPECT_EQ(times[i], 1) << i;
      EXPECT_LE(*std::max_element(times.begin(), times.end()), 1);
    }
  }
}

TEST(WideBvh, SkipsMostBoxesThatARayMisses) {
  const std::vector<Bvh::Box> boxes = randomBoxes(1500, 0);
  const Bvh tree(boxes);
  const std::vector<int> times = visits(tree, WideBvh(tree), {-1, 25, 25}, {1, 0, 0}, 0, kEndless);
  EXPECT_LT(std::count(times.begin(), times.end(), 1), 100);
}

TEST(WideBvh, LooksOnlyBetweenTheBounds) {
  std::vector<Bvh::Box> row;
  for (float x = 0; x < 100; ++x) row.push_back({Vec3f(x, 0, 0), Vec3f(x + 0.5f, 1, 1)});
  const Bvh tree(row);
  const std::vector<int> times = visits(tree, WideBvh(tree), {0, 0.5, 0.5}, {2, 0, 0}, 20, 30);
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i >= 40 && i <= 60) {
      EXPECT_EQ(times[i], 1) << i;
    } else if (i < 35 || i > 65) {  // its leaf has at most four boxes
      EXPECT_EQ(times[i], 0) << i;
    }
  }
}

TEST(WideBvh, HandlesBoxesInOnePlaceAndNoBoxes) {
  const std::vector<Bvh::Box> same(50, Bvh::Box{Vec3f(1), Vec3f(2)});
  const Bvh tree(same);
  EXPECT_EQ(visits(tree, WideBvh(tree), {0, 1.5, 1.5}, {1, 0, 0}, 0, kEndless), std::vector<int>(50, 1));
  EXPECT_TRUE(visits(Bvh({}), WideBvh(Bvh({})), {0, 0, 0}, {1, 0, 0}, 0, kEndless).empty());
}

}  // namespace
}  // namespace qrelief
