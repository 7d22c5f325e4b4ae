// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth/wall_limit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

#include "math/tolerance.h"
#include "support/brute_force.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr double kResolution = kDepthQuantumMm / 2;

/// Model seen from straight above the origin of its upper side, with a symbol there whose submodules are all carved.
struct Case {
  Mesh mesh;
  double symbolMm = 10;
  int size = 8;
  double maxDepthMm = 3;
  double minWallMm = 0.8;
  double patchRadiusMm = 1000;

  ProjectionFrame frame{};
  SubmoduleMask mask{};

  void prepare() {
    const brute_force::Hit top = brute_force::castRay(mesh, {0, 0, 500}, {0, 0, -1});
    frame = makeFrame({0, 0, 500 - top.distance}, {0, 0, 1}, {0, 1, 0}, 250);
    mask = {size, size, 1};
  }

  /// Returns the plane point of a grid position; corners are at whole numbers.
  Vec2 plane(double row, double column) const {
    const double h = symbolMm / size;
    return {-symbolMm / 2 + column * h, symbolMm / 2 - row * h};
  }

  VisiblePatch patch() const {
    const brute_force::Hit seed = brute_force::castRay(mesh, frame.eye(), {0, 0, -1});
    return findSilhouette(mesh, buildAdjacency(mesh.triangles), frame, seed.triangle, patchRadiusMm).value();
  }

  std::vector<double> limits() const { return limits(patch()); }
  std::vector<double> limits(const VisiblePatch& patch) const {
    return wallLimits(mesh, patch, frame, mask,
                      {.symbolMm = symbolMm, .maxDepthMm = maxDepthMm, .minWallMm = minWallMm});
  }

  /// Compares the limits with a closed form, `limitAt(point of a flat upper side at height z, ray)`, which is least at
  /// a corner or the centre of a submodule.
  void expectLimits(double z, const std::function<double(Vec3, Vec3)>& limitAt) const {
    const std::vector<double> actual = limits();
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        double expected = maxDepthMm;
        for (const Vec2 at : {Vec2(0.5, 0.5), Vec2(0, 0), Vec2(0, 1), Vec2(1, 0), Vec2(1, 1)}) {
          const Vec3 ray = frame.rayDirection(plane(row + at.x, column + at.y));
          const Vec3 surface = frame.eye() + ray * ((z - frame.eye().z) / ray.z);
          expected = std::min(expected, std::max(0.0, limitAt(surface, ray)));
        }
        const double limit = actual[static_cast<std::size_t>(row * size + column)];
        EXPECT_LE(limit, expected + 1e-6) << "row " << row << ", column " << column;
        EXPECT_GE(limit, expected - kResolution - 1e-6) << "row " << row << ", column " << column;
      }
    }
  }
};

TEST(WallLimit, OfAPlateIsItsThicknessMinusTheWall) {
  Case c{.mesh = shapes::plate({60, 60}, 2, 3, 3)};
  c.prepare();
  c.expectLimits(0, [&](Vec3 p, Vec3 ray) { return (2 + p.z - c.minWallMm) / -ray.z; });
}

TEST(WallLimit, OfAThickBlockIsTheMaximumDepth) {
  Case c{.mesh = shapes::box({60, 60, 60})};
  c.prepare();
  for (const double limit : c.limits()) EXPECT_EQ(limit, 3);
}

TEST(WallLimit, OfAFaceFarLargerThanTheCodeIsTheMaximumDepth) {
  // Seen from the eye, the middles of the two facets lie 3 m away.
  Case c{.mesh = shapes::translated(shapes::box({20000, 20000, 40}), {0, 4000, 0})};
  c.prepare();
  for (const double limit : c.limits()) EXPECT_EQ(limit, c.maxDepthMm);
}

TEST(WallLimit, OfAPlateThinnerThanTheWallIsZero) {
  Case c{.mesh = shapes::plate({60, 60}, 0.7, 3, 3)};
  c.prepare();
  for (const double limit : c.limits()) EXPECT_EQ(limit, 0);
}

TEST(WallLimit, OfAWedgeIsMeasuredToItsBack) {
  // The back falls from 1.2 mm at x = -30 to 13.2 mm at x = 30.
  Mesh wedge = shapes::box({60, 60, 10});
  for (Vec3f& p : wedge.positions) p.z = p.z > 0 ? 0.0f : -7.2f - 0.2f * p.x;
  Case c{.mesh = wedge, .symbolMm = 30, .size = 20};
  c.maxDepthMm = 6;
  c.prepare();
  const Vec3 outward = glm::normalize(Vec3(-0.2, 0, -1));
  c.expectLimits(0, [&](Vec3 p, Vec3 ray) {
    const double distance = glm::dot(Vec3(0, 0, -7.2) - p, outward);
    return (distance - c.minWallMm) / glm::dot(ray, outward);
  });
}

TEST(WallLimit, KeepsTheWallToASideFace) {
  // Rays lean outwards, so the vertical wall gets thinner with depth.
  Case c{.mesh = shapes::box({22, 200, 40}), .symbolMm = 20.8, .size = 26};
  c.prepare();
  c.expectLimits(20, [&](Vec3 p, Vec3 ray) {
    const double spare = 11 - std::abs(p.x) - c.minWallMm;
    if (spare < 0) return 0.0;
    return std::abs(ray.x) > 0 ? spare / std::abs(ray.x) : 1e9;
  });
}

TEST(WallLimit, KeepsTheWallToACavity) {
  // The wall between two concentric spheres is 4 mm thick; their facets lie less than 0.02 mm below the spheres.
  Case c{.mesh = shapes::together(shapes::icosphere(50, 6), shapes::insideOut(shapes::icosphere(46, 6)))};
  c.maxDepthMm = 5;
  c.prepare();
  const std::vector<double> limits = c.limits();
  for (int row = 0; row < c.size; ++row) {
    for (int column = 0; column < c.size; ++column) {
      // The limit is where the ray through the submodule comes within minWall of the cavity.
      double expected = c.maxDepthMm;
      for (const Vec2 at : {Vec2(0.5, 0.5), Vec2(0, 0), Vec2(0, 1), Vec2(1, 0), Vec2(1, 1)}) {
        const Vec3 ray = c.frame.rayDirection(c.plane(row + at.x, column + at.y));
        const double along = -glm::dot(c.frame.eye(), ray);
        const double aside2 = glm::dot(c.frame.eye(), c.frame.eye()) - along * along;
        const auto depthOf = [&](double radius) { return along - std::sqrt(radius * radius - aside2); };
        expected = std::min(expected, depthOf(46 + c.minWallMm) - depthOf(50));
      }
      EXPECT_NEAR(limits[static_cast<std::size_t>(row * c.size + column)], expected, 0.02 + kResolution);
    }
  }
}

/// Returns a model of two bodies.
Case bodies(const Mesh& carved, const Mesh& other) {
  Case c{.mesh = shapes::together(carved, other)};
  for (std::size_t t = 0; t < c.mesh.triangles.size(); ++t)
    c.mesh.bodyOf.push_back(t < carved.triangles.size() ? 0 : 1);
  c.prepare();
  return c;
}

TEST(WallLimit, IsThatOfTheBodyAloneIfItLiesOnAnother) {
  Case plate{.mesh = shapes::plate({60, 60}, 1.5, 3, 3)};
  plate.prepare();
  const Mesh base = shapes::plate({60, 60}, 4, 3, 3);
  EXPECT_EQ(bodies(plate.mesh, shapes::translated(base, {0, 0, -1.5})).limits(), plate.limits());
  EXPECT_EQ(bodies(plate.mesh, shapes::translated(base, {0, 0, -1})).limits(), plate.limits())
      << "sunk into it by less than the wall";
}

TEST(WallLimit, EndsBeforeABodyThatLiesPartlyInside) {
  const Mesh plate = shapes::plate({60, 60}, 3, 3, 3);
  for (const double top : {-0.5, -1.0, -2.0}) {  // of a post that stands out below
    const Case c = bodies(plate, shapes::translated(shapes::plate({40, 40}, 10, 3, 3), {0, 0, top}));
    for (const double limit : c.limits()) EXPECT_NEAR(limit, -top, 0.01 + kResolution) << top;
  }
  const Case beside = bodies(plate, shapes::translated(shapes::plate({40, 40}, 10, 3, 3), {40, 0, -0.5}));
  for (const double limit : beside.limits()) EXPECT_NEAR(limit, 3 - beside.minWallMm, 0.02);
}

TEST(WallLimit, KeepsAWallBeforeABodyWithin) {
  Case hollow{.mesh = shapes::together(shapes::box({60, 60, 20}), shapes::insideOut(shapes::box({56, 56, 16})))};
  hollow.prepare();
  Case nested{.mesh = shapes::together(shapes::box({60, 60, 20}), shapes::box({56, 56, 16}))};
  for (std::size_t t = 0; t < nested.mesh.triangles.size(); ++t)
    nested.mesh.bodyOf.push_back(t < nested.mesh.triangles.size() / 2 ? 0 : 1);
  nested.prepare();
  EXPECT_EQ(nested.limits(), hollow.limits());
  for (const double limit : nested.limits()) EXPECT_NEAR(limit, 2 - nested.minWallMm, 0.02);
}

TEST(WallLimit, NeverLetsABallAtAFloorTouchAHiddenFacetByBruteForce) {
  const Mesh outer = shapes::bumpySphere(30, 2, 5, 4);
  Case c{.mesh = shapes::together(outer, shapes::insideOut(shapes::icosphere(26, 3))), .symbolMm = 16, .size = 8};
  c.prepare();
  const std::vector<double> limits = c.limits();
  std::size_t limited = 0;
  for (int k = 0; k < c.size * c.size; ++k) {
    const double limit = limits[static_cast<std::size_t>(k)];
    limited += limit < c.maxDepthMm;
    const int row = k / c.size, column = k % c.size;
    const Vec3 ray = c.frame.rayDirection(c.plane(row + 0.5, column + 0.5));
    const Vec3 floor = c.frame.eye() + ray * (brute_force::castRay(c.mesh, c.frame.eye(), ray).distance + limit);
    double nearest = 1e9;
    for (std::size_t t = outer.triangles.size(); t < c.mesh.triangles.size(); ++t)
      nearest = std::min(
          nearest, brute_force::distanceToFacet(floor, c.mesh.corner(t, 0), c.mesh.corner(t, 1), c.mesh.corner(t, 2)));
    EXPECT_TRUE(limit == 0 || nearest >= c.minWallMm - 1e-6) << "submodule " << k << ": " << nearest;
  }
  EXPECT_GT(limited, 32u);
}

TEST(WallLimit, IsZeroWhereNothingIsCarved) {
  Case c{.mesh = shapes::box({60, 60, 60})};
  c.prepare();
  c.mask[5] = 0;
  const std::vector<double> limits = c.limits();
  for (std::size_t k = 0; k < limits.size(); ++k) EXPECT_EQ(limits[k], k == 5 ? 0 : 3);
}

TEST(WallLimit, IsZeroWhereThePatchDoesNotCoverTheSubmodule) {
  // The box ends 1 mm inside the symbol on the left and right, so the outermost columns overhang it.
  Case c{.mesh = shapes::box({8, 200, 60})};
  c.prepare();
  c.minWallMm = 0;
  const std::vector<double> limits = c.limits();
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const bool outermost = k % 8 == 0 || k % 8 == 7;
    EXPECT_EQ(limits[k] == 0, outermost) << k;
  }
}

TEST(WallLimit, KeepsTheWallToADraftedSideThatTheEyeSees) {
  // The sides have a mould's draft of 5°: they lean outwards by tan 5° per mm, rays by half a mm in ten.
  Mesh block = shapes::box({22, 200, 40});
  const double slope = std::tan(5 * 0.017453292519943295);
  for (Vec3f& p : block.positions)
    if (p.z < 0) p.x += static_cast<float>(p.x > 0 ? 40 * slope : -40 * slope);
  Case c{.mesh = block, .symbolMm = 20.8, .size = 26};
  c.prepare();
  ASSERT_EQ(c.patch().triangles.size(), 6u);  // the eye sees the top and both sides
  const Vec3 outward = glm::normalize(Vec3(1, 0, slope));
  c.expectLimits(20, [&](Vec3 p, Vec3 ray) {
    const Vec3 mirrored(std::abs(p.x), p.y, p.z), down(std::abs(ray.x), ray.y, ray.z);
    const double distance = glm::dot(Vec3(11, 0, 20) - mirrored, outward) - c.minWallMm;
    if (distance < 0) return 0.0;
    return glm::dot(down, outward) > 0 ? distance / glm::dot(down, outward) : 1e9;
  });
}

TEST(WallLimit, KeepsTheWallThroughASharpRidgeOfWhichTheEyeSeesBothSides) {
  // A roof of 50° at its ridge along y: next to the ridge the material is thin from the start.
  const double slope = 1 / std::tan(25 * 0.017453292519943295);
  Mesh roof;
  roof.positions = {{-10, -100, static_cast<float>(-10 * slope)},
                    {10, -100, static_cast<float>(-10 * slope)},
                    {10, 100, static_cast<float>(-10 * slope)},
                    {-10, 100, static_cast<float>(-10 * slope)},
                    {0, -100, 0},
                    {0, 100, 0}};
  roof.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {2, 3, 5}, {1, 2, 5}, {1, 5, 4}, {3, 0, 4}, {3, 4, 5}};
  Case c{.mesh = roof, .symbolMm = 4, .size = 20};
  c.prepare();
  ASSERT_GT(signedVolume(roof), 0);
  const Vec3 right = glm::normalize(Vec3(slope, 0, 1));
  const std::vector<double> limits = c.limits();
  for (int k = 0; k < c.size * c.size; ++k) {
    // Thickness is measured through the roof, perpendicular to its other side, from the submodule's point nearest to
    // the ridge.
    double thickness = 1e9;
    for (const double across : {0.0, 1.0}) {
      const int row = k / c.size, column = k % c.size;
      const Vec3 ray = c.frame.rayDirection(c.plane(row + 0.5, column + across));
      const brute_force::Hit hit = brute_force::castRay(roof, c.frame.eye(), ray);
      const Vec3 p = c.frame.eye() + ray * hit.distance;
      thickness = std::min(thickness, std::abs(glm::dot(right, Vec3(-std::abs(p.x), p.y, p.z))));
    }
    EXPECT_EQ(limits[static_cast<std::size_t>(k)] == 0, thickness < c.minWallMm) << k << ": " << thickness;
  }
}

TEST(WallLimit, OfABluntRoofIsTheMaximumDepth) {
  // At 120°, both sides of the ridge are one surface to carve.
  const double slope = 1 / std::tan(60 * 0.017453292519943295);
  const Mesh roof = shapes::plate({40, 40}, 40, 2, 2, [&](double x, double) { return -slope * std::abs(x); });
  Case c{.mesh = roof};
  c.prepare();
  for (const double limit : c.limits()) EXPECT_EQ(limit, 3);
}

TEST(WallLimit, IsZeroWithoutDepth) {
  Case c{.mesh = shapes::box({60, 60, 60})};
  c.maxDepthMm = 0;
  c.prepare();
  for (const double limit : c.limits()) EXPECT_EQ(limit, 0);
}

TEST(WallLimit, IgnoresTheSurfaceOutsideThePatch) {
  // The radius ends at the symbol's corners. The floor's facets beyond it face the eye and are not hidden.
  Case c{.mesh = shapes::plate({60, 60}, 40, 60, 60)};
  c.patchRadiusMm = c.symbolMm / std::sqrt(2.0);
  c.prepare();
  for (const double limit : c.limits()) EXPECT_EQ(limit, 3);
}

}  // namespace
}  // namespace qrelief
