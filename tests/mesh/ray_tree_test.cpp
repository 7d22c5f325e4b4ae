// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ray_tree.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

Vec3 randomVector(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

TEST(RayTree, FindsTheSameHitsAsBruteForce) {
  Random random(7);
  for (const Mesh& mesh : {shapes::box({20, 10, 5}), shapes::bumpySphere(10, 2, 3, 3), shapes::cylinder(5, 20, 64),
                           shapes::together(shapes::torus(10, 3, 24, 12), shapes::icosphere(2, 2))}) {
    const RayTree tree(mesh);
    int hits = 0;
    for (int i = 0; i < 500; ++i) {
      const Vec3 origin = randomVector(random, 25);
      const Vec3 direction = i % 2 ? -origin + randomVector(random, 8) : randomVector(random, 1);
      const auto expected = firstHit(mesh, origin, direction);
      const auto hit = tree.firstHit(origin, direction);
      ASSERT_EQ(hit.has_value(), expected.has_value());
      if (!hit) continue;
      ++hits;
      EXPECT_EQ(hit->triangle, expected->triangle);
      EXPECT_EQ(hit->distance, expected->distance);
    }
    EXPECT_GT(hits, 100);
  }
}

TEST(RayTree, HitsSidesParallelToTheRay) {
  const Mesh box = shapes::box({2, 2, 2});
  const RayTree tree(box);
  const auto hit = tree.firstHit({0.25, 0.5, 5}, {0, 0, -1});
  ASSERT_TRUE(hit.has_value());
  EXPECT_DOUBLE_EQ(hit->distance, 4);
}

TEST(RayTree, IgnoresHitsNearerThanTheMinimum) {
  const Mesh box = shapes::box({2, 2, 2});
  const RayTree tree(box);
  const auto hit = tree.firstHit({0.25, 0.5, 5}, {0, 0, -2}, 2.5);
  ASSERT_TRUE(hit.has_value());
  EXPECT_DOUBLE_EQ(hit->distance, 6);
}

TEST(RayTree, OfNoTrianglesHitsNothing) {
  const Mesh none;
  EXPECT_FALSE(RayTree(none).firstHit({0, 0, 0}, {0, 0, 1}).has_value());
}

}  // namespace
}  // namespace qrelief
