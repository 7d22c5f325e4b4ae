// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/flatness.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr MapWindow kWindow{20, 40};

/// Returns a map of heights whose surface faces the eye everywhere.
template <class Height>
std::vector<float> surfaceOf(const Height& height) {
  std::vector<float> surface;
  for (int row = 0; row < kWindow.texels; ++row)
    for (int column = 0; column < kWindow.texels; ++column) {
      const auto h = static_cast<float>(height(kWindow.planePoint(column, row)));
      surface.insert(surface.end(), {0, 0, 1, h});
    }
  return surface;
}

TEST(Bend, ATiltedPlaneHasNoBend) {
  EXPECT_NEAR(bendMm(surfaceOf([](Vec2 p) { return 3 + 0.4 * p.x - 0.7 * p.y; }), kWindow), 0, 1e-5);
}

TEST(Bend, OfACylinderMatchesAParabola) {
  // x² / 2r over |x| < a has the variance a⁴ / 45r².
  const double a = 10, r = 30;
  const double expected = a * a / (std::sqrt(45) * r);
  EXPECT_NEAR(bendMm(surfaceOf([&](Vec2 p) { return -p.x * p.x / (2 * r); }), kWindow), expected, 0.005 * expected);
}

TEST(PlaneFit, AFitOfAPartIsTheDifferenceOfFits) {
  const auto height = [](Vec2 p) { return 0.3 * p.x + 0.02 * p.x * p.y - 0.05 * p.y * p.y; };
  PlaneFit all, left, right;
  for (int x = -20; x < 20; ++x) {
    for (int y = -7; y < 7; ++y) {
      all.add(Vec2(x, y), height({x, y}));
      (x < 3 ? left : right).add(Vec2(x, y), height({x, y}));
    }
  }
  PlaneFit difference = all;
  difference -= left;
  EXPECT_NEAR(difference.rms(), right.rms(), 1e-9);
  EXPECT_EQ(difference.weight(), right.weight());
  left += right;
  EXPECT_NEAR(left.rms(), all.rms(), 1e-9);
}

TEST(Bend, IgnoresTexelsOutsideTheModel) {
  std::vector<float> surface = surfaceOf([](Vec2 p) { return p.x > 5 ? 100 : 0.1 * p.x; });
  for (int row = 0; row < kWindow.texels; ++row)
    for (int column = 0; column < kWindow.texels; ++column)
      if (kWindow.planePoint(column, row).x > 5)
        surface[4 * static_cast<std::size_t>(row * kWindow.texels + column) + 2] = 0;
  EXPECT_NEAR(bendMm(surface, kWindow), 0, 1e-5);
  EXPECT_EQ(bendMm(std::vector<float>(surface.size(), 0.0f), kWindow), 0);
}

TEST(Bend, OfAMeshCoversOnlyTheGivenFacets) {
  // Two plates form a step: together they bend, each alone does not.
  const Mesh mesh = shapes::together(shapes::translated(shapes::box({40, 40, 4}), {0, 0, -2}),
                                     shapes::translated(shapes::box({20, 40, 2}), {-10, 0, 1}));
  const ProjectionFrame frame = makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 250);
  std::vector<std::uint32_t> all, lower;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    all.push_back(t);
    if (std::max({mesh.corner(t, 0).z, mesh.corner(t, 1).z, mesh.corner(t, 2).z}) < 1) lower.push_back(t);
  }
  EXPECT_NEAR(bendMm(mesh, lower, frame, 30), 0, 1e-5);
  // A step of 2 in the middle has a variance of 1; the inclined plane accounts for three quarters of it.
  EXPECT_NEAR(bendMm(mesh, all, frame, 30), 0.5, 0.02);
}

TEST(Bend, TheAimToleranceFallsWithTheBend) {
  EXPECT_EQ(aimToleranceDeg(0, 1), kMaxAimDeg);
  EXPECT_NEAR(aimToleranceDeg(1.36, 1), 10, 0.1);
  EXPECT_NEAR(aimToleranceDeg(2 * 1.36, 2), 10, 0.1);
  EXPECT_LT(aimToleranceDeg(3, 1), aimToleranceDeg(2, 1));
}

}  // namespace
}  // namespace qrelief
