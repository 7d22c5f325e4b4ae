// SPDX-License-Identifier: GPL-3.0-or-later
#include "printing/printed_rays.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "base/random.h"
#include "mesh/ray_tree.h"

namespace qrelief {
namespace {

/// Returns a made-up surface: hills, a pit with steep walls, and a hole.
PrintedSurface surface(int texels) {
  PrintedSurface made;
  made.frame = makeFrame({3, -2, 5}, {1, 2, 3}, {0, 0, 1}, 250);
  made.texels = texels;
  made.texelMm = 12.0 / texels;
  for (int row = 0; row < texels; ++row)
    for (int column = 0; column < texels; ++column) {
      const Vec2 at = made.planePoint(column, row);
      double height = 0.4 * std::sin(2.1 * at.x) * std::cos(1.7 * at.y) - 0.05 * at.x;
      if (std::abs(at.x - 1) < 1.5 && std::abs(at.y + 1) < 1) height -= 0.8;
      const bool hole = glm::length(at - Vec2(-3, 3)) < 0.8;
      const double way = std::sqrt(at.x * at.x + at.y * at.y + 250.0 * 250.0);
      made.distanceMm.push_back(hole ? 0 : static_cast<float>(way * (1 - height / 250)));
    }
  return made;
}

Vec3 onSphere(Random& random) {
  const double z = 2 * random.uniform() - 1, turn = 2 * std::numbers::pi * random.uniform();
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

TEST(PrintedRays, TheEyeSeesThePointsOfTheSurface) {
  const PrintedSurface made = surface(60);
  const PrintedRays rays(made);
  for (int row = 1; row + 1 < made.texels; row += 3)
    for (int column = 1; column + 1 < made.texels; column += 3) {
      const double distance =
          static_cast<double>(made.distanceMm[static_cast<std::size_t>(row * made.texels + column)]);
      const auto hit = rays.firstHit(made.frame.eye(), made.frame.rayDirection(made.planePoint(column, row)));
      if (!hit) {
        EXPECT_TRUE(distance <= 0 || glm::length(made.planePoint(column, row) - Vec2(-3, 3)) < 1.2);
        continue;
      }
      EXPECT_NEAR(hit->distance, distance, 1e-4) << column << ", " << row;
    }
  EXPECT_FALSE(rays.firstHit(made.frame.eye(), made.frame.normal));
  EXPECT_FALSE(rays.firstHit(made.frame.eye(), made.frame.rayDirection({6.5, 0})));
}

TEST(PrintedRays, RaysFromTheSurfaceHitTheSameAsARayTree) {
  for (const int texels : {17, 60, 133}) {
    const PrintedSurface made = surface(texels);
    const PrintedRays rays(made);
    const Mesh mesh = made.mesh();
    const RayTree tree(mesh);
    Random random(7);
    int hits = 0, all = 0, apart = 0;
    for (int k = 0; k < 20000; ++k) {
      const Vec2 at((random.uniform() - 0.5) * 11, (random.uniform() - 0.5) * 11);
      const auto start = tree.firstHit(made.frame.eye(), made.frame.rayDirection(at));
      if (!start) continue;
      Vec3 direction = onSphere(random) * (0.5 + random.uniform());
      Vec3 normal = tree.normalAt(*start);
      if (glm::dot(normal, made.frame.normal) < 0) normal = -normal;
      if (glm::dot(direction, normal) < 0) direction = -direction;
      if (glm::dot(direction, normal) < 0.01) continue;  // rounding decides which of two neighbours the ray meets
      const auto wanted = tree.firstHit(start->position, direction, 1e-6),
                 found = rays.firstHit(start->position, direction, 1e-6);
      // A hit from below, through the hole or beyond the border, is not on the eye's side.
      if (wanted && glm::dot(tree.normalAt(*wanted), direction) > 0) continue;
      ++all;
      hits += wanted.has_value();
      if (wanted.has_value() != found.has_value() || (wanted && glm::length(wanted->position - found->position) > 1e-4))
        ++apart;
      if (wanted && found && glm::length(wanted->position - found->position) < 1e-6) {
        EXPECT_NEAR(wanted->distance, found->distance, 1e-6);
        EXPECT_NEAR(std::abs(glm::dot(tree.normalAt(*wanted), rays.normalAt(*found))), 1, 1e-3);
      }
    }
    EXPECT_GT(all, 10000) << texels;
    EXPECT_GT(hits, all / 20) << texels;
    EXPECT_LE(apart, all / 1000) << texels << " texels: " << apart << " of " << all;
  }
}

TEST(PrintedRays, ARayFromFarAwayHitsTheSurface) {
  const PrintedSurface made = surface(60);
  const PrintedRays rays(made);
  const Mesh mesh = made.mesh();
  const RayTree tree(mesh);
  Random random(3);
  int apart = 0, hits = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 to = made.frame.onPlane({(random.uniform() - 0.5) * 10, (random.uniform() - 0.5) * 10});
    const Vec3 origin = to + made.frame.normal * (20 + 100 * random.uniform()) + 30.0 * onSphere(random);
    const auto wanted = tree.firstHit(origin, to - origin), found = rays.firstHit(origin, to - origin);
    if (wanted && glm::dot(tree.normalAt(*wanted), to - origin) > 0) continue;
    hits += found.has_value();
    apart +=
        wanted.has_value() != found.has_value() || (wanted && glm::length(wanted->position - found->position) > 1e-4);
  }
  EXPECT_GT(hits, 1500);
  EXPECT_LE(apart, 4);
}

TEST(PrintedRays, IgnoresHitsNearerThanTheMinimum) {
  const PrintedSurface made = surface(60);
  const PrintedRays rays(made);
  const Vec3 down = made.frame.rayDirection({1, 1});
  const auto hit = rays.firstHit(made.frame.eye(), down);
  ASSERT_TRUE(hit);
  EXPECT_FALSE(rays.firstHit(made.frame.eye(), down, hit->distance + 0.01));
  const Vec3 above = made.frame.eye() + down * 200.0;
  EXPECT_NEAR(rays.firstHit(above, down)->distance, hit->distance - 200, 1e-6);
  EXPECT_FALSE(rays.firstHit(above, down, hit->distance - 200 + 0.01));
}

}  // namespace
}  // namespace qrelief
