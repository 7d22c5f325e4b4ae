// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/view_raster.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

#include "projection/distance_transform.h"
#include "support/brute_force.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr double kEyeDistance = 300;

ProjectionFrame lookAlong(Vec3 direction) { return makeFrame({0, 0, 0}, direction, {0, 0, 1}, kEyeDistance); }

TEST(ViewRaster, CoversTheOutlineOfASphere) {
  const Mesh sphere = shapes::icosphere(40, 5);
  const Adjacency adjacency = buildAdjacency(sphere.triangles);
  ViewRaster raster(sphere, adjacency);
  raster.draw(lookAlong({1, 2, 3}), {100, 256}, 0);
  const double outlineSquared = 40.0 * 40 / (1 - 40.0 * 40 / (kEyeDistance * kEyeDistance));
  EXPECT_NEAR(raster.coveredMm2(), std::numbers::pi * outlineSquared, 0.01 * std::numbers::pi * outlineSquared);
}

TEST(ViewRaster, ACopyDrawsAViewOfItsOwn) {
  const Mesh mesh = shapes::bumpySphere(40, 3, 4, 4);
  const Adjacency adjacency = buildAdjacency(mesh.triangles);
  const RasterWindow window{100, 128};
  ViewRaster raster(mesh, adjacency), alone(mesh, adjacency);
  ViewRaster copy = raster;
  raster.draw(lookAlong({1, 2, 3}), window, 0.5);
  copy.draw(lookAlong({-3, 1, 0}), window, 0.5);
  alone.draw(lookAlong({1, 2, 3}), window, 0.5);
  EXPECT_TRUE(std::equal(raster.blocked().begin(), raster.blocked().end(), alone.blocked().begin()));
  EXPECT_FALSE(std::equal(raster.blocked().begin(), raster.blocked().end(), copy.blocked().begin()));
}

TEST(ViewRaster, BlocksASphereInwardsFromItsOutlineWhereItIsTooOblique) {
  const Mesh sphere = shapes::icosphere(40, 5);
  const Adjacency adjacency = buildAdjacency(sphere.triangles);
  ViewRaster raster(sphere, adjacency);
  const RasterWindow window{100, 200};
  raster.draw(lookAlong({0, 0, 1}), window, std::cos(std::numbers::pi / 3));
  // At polar angle θ the angle to the line of sight is θ + φ, tan φ = r·sin θ / (L - r·cos θ).
  double theta = 0, phi = 0;
  while (theta + phi < std::numbers::pi / 3) {
    theta += 1e-5;
    phi = std::atan(40 * std::sin(theta) / (kEyeDistance - 40 * std::cos(theta)));
  }
  const double rim = kEyeDistance * std::tan(phi);
  const std::vector<std::int32_t> squared = squaredDistances(raster.blocked(), window.texels);
  const double middle = std::sqrt(squared[100 * 200 + 100]) * window.texelMm();
  EXPECT_NEAR(middle, rim, 40 * 0.04 + window.texelMm());  // facets are flat: 0.04 of the radius wide
}

TEST(ViewRaster, HasContoursInFrontOfASurfaceButNoneBehindIt) {
  // A small cube lies in front of the middle of a plate, and another behind it.
  const Mesh plate = shapes::box({120, 120, 4});
  const Mesh cube = shapes::box({10, 10, 10});
  const RasterWindow window{160, 160};
  const auto isBlockedNear = [&](const Mesh& mesh, Vec2 at) {
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    ViewRaster raster(mesh, adjacency);
    raster.draw(lookAlong({0, 0, 1}), window, 0);
    const std::vector<std::int32_t> squared = squaredDistances(raster.blocked(), window.texels);
    const auto column = static_cast<std::size_t>(at.x + 80), row = static_cast<std::size_t>(at.y + 80);
    return squared[row * 160 + column] <= 9;
  };
  EXPECT_TRUE(isBlockedNear(shapes::together(plate, shapes::translated(cube, {0, 0, 30})), {5, 0}));
  EXPECT_FALSE(isBlockedNear(shapes::together(plate, shapes::translated(cube, {0, 0, -30})), {5, 0}));
}

TEST(ViewRaster, HasTheVerticesThatRaysReach) {
  const Mesh torus = shapes::torus(30, 12, 48, 24);
  const Adjacency adjacency = buildAdjacency(torus.triangles);
  const std::vector<Vec3f> normals = vertexNormals(torus);
  ViewRaster raster(torus, adjacency);
  const RasterWindow window{110, 220};
  const ProjectionFrame frame = lookAlong({3, 1, 1});
  raster.draw(frame, window, 0);
  const std::vector<std::int32_t> squared = squaredDistances(raster.blocked(), window.texels);
  int seen = 0, hidden = 0;
  for (std::uint32_t v = 0; v < torus.positions.size(); ++v) {
    const Vec3 p(torus.positions[v]);
    const Vec2 at = raster.at(v);
    const auto texel = static_cast<std::size_t>(at.y) * 220 + static_cast<std::size_t>(at.x);
    if (glm::dot(Vec3(normals[v]), frame.eye() - p) <= 0 || squared[texel] < 9) continue;
    const double distance = glm::distance(frame.eye(), p);
    const bool reached =
        brute_force::castRay(torus, frame.eye(), (p - frame.eye()) / distance).distance > distance - 1e-3;
    EXPECT_EQ(raster.sees(v), reached) << v;
    ++(reached ? seen : hidden);
  }
  EXPECT_GT(seen, 100);
  EXPECT_GT(hidden, 20);
}

}  // namespace
}  // namespace qrelief
