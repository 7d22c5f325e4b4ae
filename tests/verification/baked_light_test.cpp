// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/baked_light.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "mesh/ray_tree.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

ProjectionFrame fromAbove() { return makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 250); }

BakedLight baked(const RayTree& tree, const BakeOptions& options) {
  BakedLight light(tree, fromAbove(), options);
  while (!light.bakeRows(7)) {
  }
  return light;
}

Mesh plateWithPit(double radius, double depth) {
  return shapes::plate({24, 24}, 20, 240, 240,
                       [&](double x, double y) { return std::hypot(x, y) < radius ? -depth : 0.0; });
}

/// Returns the mean over the texels within `reach` of the middle.
SurfaceLight meanOfMiddle(const BakedLight& light, double reach) {
  const int edge = light.options().texels;
  SurfaceLight sum;
  int count = 0;
  for (int i = 0; i < edge * edge; ++i) {
    const int row = i / edge, column = i % edge;
    const double x = (column + 0.5 - edge / 2.0) * light.options().texelMm;
    const double y = (row + 0.5 - edge / 2.0) * light.options().texelMm;
    if (std::hypot(x, y) > reach) continue;
    sum.sky += light.light().at(row, column).sky;
    sum.lamp += light.light().at(row, column).lamp;
    ++count;
  }
  return {sum.sky / count, sum.lamp / count};
}

TEST(BakedLight, AnOpenPlaneHasTheSkyAndTheCosinesOfTheLamps) {
  const Mesh plate = shapes::box({40, 40, 4});
  const RayTree tree(plate);
  const double elevation = 0.7;
  const BakedLight light = baked(
      tree, {.texelMm = 0.5,
             .texels = 20,
             .lamps = {{.towards = {std::cos(elevation), 0, std::sin(elevation)}, .strength = 0.5, .radiusDeg = 0},
                       {.towards = {0, 0, 1}, .strength = 0.25, .radiusDeg = 0}}});
  for (const SurfaceLight& one : light.light()) {
    EXPECT_EQ(one.sky, 1);
    EXPECT_NEAR(one.lamp, 0.5 * std::sin(elevation) + 0.25, 1e-9);
  }
}

TEST(BakedLight, TheMiddleOfAPitMatchesTheClosedForm) {
  const double grid = 0.1, radius = 3, depth = 2;
  const Mesh pit = plateWithPit(radius, depth);
  const RayTree tree(pit);
  const BakedLight light = baked(tree, {.texelMm = 0.05, .texels = 20, .paths = 256, .albedo = 0});
  const double rim = radius + grid / 2;
  EXPECT_NEAR(meanOfMiddle(light, 0.1).sky, rim * rim / (rim * rim + depth * depth), 0.01);
}

TEST(BakedLight, OmitsTheBorderAndChangesNothingInside) {
  const Mesh pit = plateWithPit(0.6, 0.5);
  const RayTree tree(pit);
  constexpr int kEdge = 20, kBorder = 4;
  const BakedLight all = baked(tree, {.texelMm = 0.1, .texels = kEdge});
  const BakedLight part = baked(tree, {.texelMm = 0.1, .texels = kEdge, .border = kBorder});
  for (int row = 0; row < kEdge; ++row)
    for (int column = 0; column < kEdge; ++column) {
      const bool within = std::min({row, column, kEdge - 1 - row, kEdge - 1 - column}) >= kBorder;
      const auto texel = static_cast<std::size_t>(row * kEdge + column);
      EXPECT_EQ(part.light()[texel].sky, within ? all.light()[texel].sky : -1) << row << ' ' << column;
    }
}

TEST(BakedLight, ALowLampLeavesThePitDark) {
  const Mesh pit = plateWithPit(3, 2);
  const RayTree tree(pit);
  const double elevation = 20 * std::numbers::pi / 180;  // the rim hides all light from below 33°
  const Lamp lamp{.towards = {0, std::cos(elevation), std::sin(elevation)}, .strength = 1, .radiusDeg = 5};
  const BakedLight light = baked(tree, {.texelMm = 0.05, .texels = 20, .albedo = 0, .lamps = {lamp}});
  EXPECT_EQ(meanOfMiddle(light, 0.3).lamp, 0);
}

TEST(BakedLight, SmoothingKeepsTheMeanOfAFloorAndRemovesMostNoise) {
  const Mesh pit = plateWithPit(4, 3);
  const RayTree tree(pit);
  BakedLight light = baked(tree, {.texelMm = 0.05, .texels = 40, .paths = 4});
  const auto spread = [&] {
    double mean = meanOfMiddle(light, 0.8).sky, squares = 0;
    int count = 0;
    for (int row = 10; row < 30; ++row)
      for (int column = 10; column < 30; ++column) {
        const double d = light.light().at(row, column).sky - mean;
        squares += d * d;
        ++count;
      }
    return std::sqrt(squares / count);
  };
  const double mean = meanOfMiddle(light, 0.8).sky, noise = spread();
  light.smooth();
  EXPECT_NEAR(meanOfMiddle(light, 0.8).sky, mean, 0.01);
  EXPECT_NEAR(spread(), noise / 3, noise * 0.1);
}

TEST(BakedLight, ATiltedPictureShowsTheLightComputedFromTheFront) {
  const Mesh pit = plateWithPit(3, 0.5);
  const RayTree tree(pit);
  BakedLight light = baked(tree, {.texelMm = 0.1, .texels = 160});
  light.smooth();
  const ProjectionFrame camera = tilted(fromAbove(), 30, 0);
  const LinearPicture picture = light.picture(camera, 100, 0.1);
  int compared = 0;
  for (int row = 30; row < 70; ++row) {
    for (int column = 30; column < 70; ++column) {
      const Vec2 at{(column + 0.5 - 50) * 0.1, (row + 0.5 - 50) * 0.1};
      const auto hit = tree.firstHit(camera.eye(), camera.rayDirection(at));
      ASSERT_TRUE(hit);
      if (std::hypot(hit->position.x, hit->position.y) > 2.7 || hit->position.z > -0.499) continue;
      const Vec2 front = fromAbove().project(hit->position) / 0.1 + Vec2(80);
      const SurfaceLight& texel = light.light().at(static_cast<int>(front.y), static_cast<int>(front.x));
      EXPECT_EQ(picture.sky.at(row, column), static_cast<float>(texel.sky));
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(BakedLight, WhatIsNoModelIsTheBackground) {
  const Mesh plate = shapes::box({4, 4, 4});
  const RayTree tree(plate);
  const BakedLight light = baked(tree, {.texelMm = 0.5, .texels = 20});
  EXPECT_LT(light.light()[0].sky, 0);
  EXPECT_FLOAT_EQ(light.picture(fromAbove(), 20, 0.5).sky[0], 0.35f);
}

TEST(Tilted, LeansTheCameraTowardsTheAzimuth) {
  const ProjectionFrame frame = fromAbove();
  const ProjectionFrame right = tilted(frame, 30, 0), top = tilted(frame, 45, 90);
  EXPECT_NEAR(right.normal.x, 0.5, 1e-12);
  EXPECT_NEAR(right.normal.z, std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(top.normal.y, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(top.normal.z, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(glm::dot(top.up, top.normal), 0, 1e-12);
}

}  // namespace
}  // namespace qrelief
