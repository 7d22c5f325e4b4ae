// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/printed_rays.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "base/random.h"
#include "mesh/ray_tree.h"

namespace qrelief::study {
namespace {

/// Returns a made-up surface: hills, a pit with steep walls, and a hole.
PrintedSurface surface(int texels) {
  PrintedSurface surface;
  surface.frame = makeFrame({3, -2, 5}, {1, 2, 3}, {0, 0, 1}, 250);
  surface.texels = texels;
  surface.texelMm = 12.0 / texels;
  for (int row = 0; row < texels; ++row)
    for (int column = 0; column < texels; ++column) {
      const Vec2 at = surface.planePoint(column, row);
      double height = 0.4 * std::sin(2.1 * at.x) * std::cos(1.7 * at.y) - 0.05 * at.x;
      if (std::abs(at.x - 1) < 1.5 && std::abs(at.y + 1) < 1) height -= 0.8;
      const bool hole = glm::length(at - Vec2(-3, 3)) < 0.8;
      const double way = std::sqrt(at.x * at.x + at.y * at.y + 250.0 * 250.0);
      surface.distanceMm.push_back(hole ? 0 : static_cast<float>(way * (1 - height / 250)));
    }
  return surface;
}

Vec3 onSphere(Random& random) {
  const double z = 2 * random.uniform() - 1, turn = 2 * std::numbers::pi * random.uniform();
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

TEST(PrintedRays, TheEyeSeesThePointsOfTheSurface) {
  const PrintedSurface printed = surface(60);
  const PrintedRays rays(printed);
  for (int row = 1; row + 1 < printed.texels; row += 3)
    for (int column = 1; column + 1 < printed.texels; column += 3) {
      const double distance =
          static_cast<double>(printed.distanceMm[static_cast<std::size_t>(row * printed.texels + column)]);
      const auto hit = rays.firstHit(printed.frame.eye(), printed.frame.rayDirection(printed.planePoint(column, row)));
      if (!hit) {
        EXPECT_TRUE(distance <= 0 || glm::length(printed.planePoint(column, row) - Vec2(-3, 3)) < 1.2);
        continue;
      }
      EXPECT_NEAR(hit->distance, distance, 1e-4) << column << ", " << row;
    }
  EXPECT_FALSE(rays.firstHit(printed.frame.eye(), printed.frame.normal));
  EXPECT_FALSE(rays.firstHit(printed.frame.eye(), printed.frame.rayDirection({6.5, 0})));
}

TEST(PrintedRays, RaysFromTheSurfaceHitTheSameAsARayTree) {
  for (const int texels : {17, 60, 133}) {
    const PrintedSurface printed = surface(texels);
    const PrintedRays rays(printed);
    const Mesh mesh = printed.mesh();
    const RayTree tree(mesh);
    Random random(7);
    int hits = 0, all = 0, apart = 0;
    for (int k = 0; k < 20000; ++k) {
      const Vec2 at((random.uniform() - 0.5) * 11, (random.uniform() - 0.5) * 11);
      const auto start = tree.firstHit(printed.frame.eye(), printed.frame.rayDirection(at));
      if (!start) continue;
      Vec3 direction = onSphere(random) * (0.5 + random.uniform());
      Vec3 normal = tree.normalAt(*start);
      if (glm::dot(normal, printed.frame.normal) < 0) normal = -normal;
      if (glm::dot(direction, normal) < 0) direction = -direction;
      if (glm::dot(direction, normal) < 0.01) continue;  // rounding decides which of two neighbours the ray meets
      const auto expected = tree.firstHit(start->position, direction, 1e-6),
                 found = rays.firstHit(start->position, direction, 1e-6);
      // A hit from below, through the hole or beyond the border, is not on the eye's side.
      if (expected && glm::dot(tree.normalAt(*expected), direction) > 0) continue;
      ++all;
      hits += expected.has_value();
      if (expected.has_value() != found.has_value() ||
          (expected && glm::length(expected->position - found->position) > 1e-4))
        ++apart;
      if (expected && found && glm::length(expected->position - found->position) < 1e-6) {
        EXPECT_NEAR(expected->distance, found->distance, 1e-6);
        EXPECT_NEAR(std::abs(glm::dot(tree.normalAt(*expected), rays.normalAt(*found))), 1, 1e-3);
      }
    }
    EXPECT_GT(all, 10000) << texels;
    EXPECT_GT(hits, all / 20) << texels;
    EXPECT_LE(apart, all / 1000) << texels << " texels: " << apart << " of " << all;
  }
}

TEST(PrintedRays, ARayFromFarAwayHitsTheSurface) {
  const PrintedSurface printed = surface(60);
  const PrintedRays rays(printed);
  const Mesh mesh = printed.mesh();
  const RayTree tree(mesh);
  Random random(3);
  int apart = 0, hits = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 to = printed.frame.onPlane({(random.uniform() - 0.5) * 10, (random.uniform() - 0.5) * 10});
    const Vec3 origin = to + printed.frame.normal * (20 + 100 * random.uniform()) + 30.0 * onSphere(random);
    const auto expected = tree.firstHit(origin, to - origin), found = rays.firstHit(origin, to - origin);
    if (expected && glm::dot(tree.normalAt(*expected), to - origin) > 0) continue;
    hits += found.has_value();
    apart += expected.has_value() != found.has_value() ||
             (expected && glm::length(expected->position - found->position) > 1e-4);
  }
  EXPECT_GT(hits, 1500);
  EXPECT_LE(apart, 4);
}

TEST(PrintedRays, IgnoresHitsNearerThanTheMinimum) {
  const PrintedSurface printed = surface(60);
  const PrintedRays rays(printed);
  const Vec3 down = printed.frame.rayDirection({1, 1});
  const auto hit = rays.firstHit(printed.frame.eye(), down);
  ASSERT_TRUE(hit);
  EXPECT_FALSE(rays.firstHit(printed.frame.eye(), down, hit->distance + 0.01));
  const Vec3 above = printed.frame.eye() + down * 200.0;
  EXPECT_NEAR(rays.firstHit(above, down)->distance, hit->distance - 200, 1e-6);
  EXPECT_FALSE(rays.firstHit(above, down, hit->distance - 200 + 0.01));
}

}  // namespace
}  // namespace qrelief::study
