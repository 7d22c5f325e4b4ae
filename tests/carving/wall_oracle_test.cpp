// SPDX-License-Identifier: GPL-3.0-or-later
// Wall limits (depth/wall_limit.h) and embedding together, compared with the model by brute force: in every
// direction, pockets keep the minimum wall from any surface that the eye does not see or sees edge-on.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "carving/carving_oracle.h"
#include "depth/wall_limit.h"
#include "math/tolerance.h"
#include "support/brute_force.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr double kMinWallMm = 0.8;
constexpr double kMaxDepthMm = 1.5;

struct Body {
  const char* name;
  Mesh mesh;
  Vec3 from{0, 0, 300};  ///< start of the ray that meets the body at the code's centre
  Vec3 normal{0, 0, 1};
  double symbolMm = 12;
};

/// Builds a sheet of even thickness: the upper face, its flipped copy `thickness` below, and the sides that join them.
Mesh sheet(const std::function<double(double, double)>& height, double halfMm, double thickness, int n) {
  Mesh mesh = shapes::plate({2 * halfMm, 2 * halfMm}, 50, n, n, height);
  // The plate's bottom is only two triangles, so the sheet uses a grid for it as well.
  Mesh lower = mesh;
  for (Mesh* side : {&mesh, &lower}) {
    std::vector<Triangle> upper;
    for (std::size_t t = 0; t < side->triangles.size(); ++t)
      if (triangleNormal(*side, t).z > 0.1) upper.push_back(side->triangles[t]);
    side->triangles = upper;
  }
  const auto offset = static_cast<std::uint32_t>(mesh.positions.size());
  for (Vec3f p : lower.positions) mesh.positions.push_back(p - Vec3f(0, 0, static_cast<float>(thickness)));
  const std::vector<Triangle> upper = mesh.triangles;
  const Adjacency adjacency = buildAdjacency(upper);
  for (std::size_t t = 0; t < upper.size(); ++t) {
    const Triangle& c = upper[t];
    mesh.triangles.push_back({c[0] + offset, c[2] + offset, c[1] + offset});
    for (std::size_t k = 0; k < 3; ++k) {
      if (adjacency[t][k] != kNoTriangle) continue;
      const std::uint32_t a = c[k], b = c[(k + 1) % 3];
      mesh.triangles.push_back({a, a + offset, b + offset});
      mesh.triangles.push_back({a, b + offset, b});
    }
  }
  return oracle::welded(mesh);
}

Mesh wedge() {
  Mesh mesh = shapes::plate({30, 30}, 1, 4, 4);
  for (Vec3f& p : mesh.positions)
    if (p.z < -0.5f) p.z = -1.4f - 0.12f * (p.x + 15);
  return mesh;
}

/// Returns a block drafted by 4°, so that the eye sees its sides.
Mesh draftedBlock() {
  Mesh mesh = shapes::box({16, 60, 20});
  for (Vec3f& p : mesh.positions)
    if (p.z < 0) p.x *= 1.2f;
  return shapes::translated(mesh, {0, 0, -10});
}

/// Returns four faces that meet in an apex, with 2.2 mm of material between them and a cavity of the same shape.
Mesh hollowPyramid() {
  const auto pyramid = [](float half, float top) {
    Mesh mesh;
    mesh.positions = {{-half, -half, -30}, {half, -half, -30}, {half, half, -30}, {-half, half, -30}, {0, 0, top}};
    mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 1}, {0, 3, 2}};
    return mesh;
  };
  Mesh cavity = pyramid(40, -2.2f);
  for (Vec3f& p : cavity.positions) p.z = std::max(p.z, -20.0f) - (p.z < -20 ? 5.0f : 0.0f);
  return shapes::together(pyramid(60, 0), shapes::insideOut(cavity));
}

std::vector<Body> bodies() {
  const auto saddle = [](double x, double y) { return (x * x - y * y) / 30; };
  const auto waves = [](double x, double y) { return 0.6 * std::sin(x) * std::cos(0.8 * y); };
  return {
      {"thin shell", shapes::together(shapes::icosphere(20, 4), shapes::insideOut(shapes::icosphere(18.2, 4)))},
      {"shell thinner than the wall",
       shapes::together(shapes::icosphere(20, 4), shapes::insideOut(shapes::icosphere(19.4, 4)))},
      {"box with a cavity that comes near in one corner",
       shapes::together(shapes::translated(shapes::box({40, 40, 20}), {0, 0, -10}),
                        shapes::insideOut(shapes::translated(shapes::icosphere(6, 2), {4, 3, -7.3})))},
      {"two shells side by side", shapes::together(shapes::translated(shapes::box({13, 40, 20}), {0, 0, -10}),
                                                   shapes::translated(shapes::box({13, 40, 20}), {13.2, 0, -12}))},
      {"wedge", wedge()},
      {"hollow pyramid of few facets", hollowPyramid()},
      {"saddle", sheet(saddle, 14, 2.0, 24)},
      {"wavy sheet", sheet(waves, 14, 1.6, 40)},
      {"drafted block", draftedBlock(), {2, 0, 300}},
      {"block seen obliquely beside its edge",
       shapes::translated(shapes::box({40, 40, 20}), {0, 0, -10}),
       {13, 0, 300},
       {-0.3, 0.1, 1}},
  };
}

/// Returns the facets within reach of the centre whose middle the eye does not see or sees edge-on.
std::vector<std::uint32_t> otherSides(const Mesh& mesh, const ProjectionFrame& frame, double reach) {
  std::vector<std::uint32_t> sides;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (brute_force::distanceToFacet(frame.centre, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)) > reach)
      continue;
    const Vec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    const Vec3 ray = glm::normalize(middle - frame.eye());
    const bool seen = glm::dot(triangleNormal(mesh, t), -ray) >= kGrazingCosine &&
                      brute_force::castRay(mesh, frame.eye(), ray).triangle == t;
    if (!seen) sides.push_back(t);
  }
  return sides;
}

double leastDistance(Vec3 p, const Mesh& mesh, std::span<const std::uint32_t> facets, double reach) {
  double least = reach;
  for (const std::uint32_t t : facets) {
    const Vec3 a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
    const Vec3 lo = glm::min(glm::min(a, b), c) - least, hi = glm::max(glm::max(a, b), c) + least;
    if (glm::any(glm::lessThan(p, lo)) || glm::any(glm::greaterThan(p, hi))) continue;
    least = std::min(least, brute_force::distanceToFacet(p, a, b, c));
  }
  return least;
}

TEST(WallOracle, PocketsKeepTheMinimumWallToEveryOtherSide) {
  std::mt19937 random(20261121);
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.name);
    const auto spot = brute_force::spotSeen(body.mesh, body.from, {0, 0, -1}, body.normal, {0.2, 1, 0});
    const auto patch = findSilhouette(body.mesh, buildAdjacency(body.mesh.triangles), spot.frame, spot.seed, 1000);
    ASSERT_TRUE(patch) << patch.error().message;
    constexpr int kSize = 24;
    SubmoduleMask mask(kSize, kSize);
    for (std::uint8_t& cell : mask) cell = random() % 3 != 0;
    const std::vector<double> limits =
        wallLimits(body.mesh, *patch, spot.frame, mask,
                   {.symbolMm = body.symbolMm, .maxDepthMm = kMaxDepthMm, .minWallMm = kMinWallMm});
    DepthField field{kSize, body.symbolMm, {}};
    for (const double limit : limits) field.depthMm.push_back(std::floor(limit / kDepthQuantumMm) * kDepthQuantumMm);
    const std::vector<std::uint32_t> sides = otherSides(body.mesh, spot.frame, body.symbolMm + kMaxDepthMm);
    const auto carved = embedDepthField(body.mesh, spot.frame, patch->triangles, field, {.inlay = true});
    ASSERT_TRUE(carved) << carved.error().message;
    EXPECT_EQ(oracle::solidProblems(*carved), "");

    double least = 1e9;
    for (std::size_t t = 0; t < carved->inlay.triangles.size(); ++t)
      for (int i = 0; i <= 2; ++i)
        for (int j = 0; i + j <= 2; ++j) {
          const Vec3 p = (carved->inlay.corner(t, 0) * (2.0 - i - j) + carved->inlay.corner(t, 1) * (1.0 * i) +
                          carved->inlay.corner(t, 2) * (1.0 * j)) /
                         2.0;
          least = std::min(least, leastDistance(p, body.mesh, sides, 3 * kMinWallMm));
        }
    // Outlines move by up to snapMm, and floors bulge between the sampled points.
    EXPECT_GE(least, kMinWallMm - 0.02);
    const std::string name = body.name;
    if (name == "shell thinner than the wall")
      EXPECT_TRUE(carved->inlay.triangles.empty());
    else
      EXPECT_LE(least, kMinWallMm + 0.1);  // the limit is used: each body is thin somewhere
  }
}

}  // namespace
}  // namespace qrelief
