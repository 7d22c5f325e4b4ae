// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/weld_near.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "mesh/weld.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

/// Gives every triangle its own corners, each up to `jitter` off along every axis.
Mesh looseAndShaken(const Mesh& mesh, double jitter) {
  Random random(7);
  Mesh loose;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto first = static_cast<std::uint32_t>(loose.positions.size());
    for (int k = 0; k < 3; ++k) {
      const auto off = [&] { return random.uniform(-jitter, jitter); };
      loose.positions.emplace_back(mesh.corner(t, k) + Vec3(off(), off(), off()));
    }
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  return loose;
}

TEST(WeldNear, ClosesLooseTrianglesWithinTheTolerance) {
  const Mesh sphere = shapes::icosphere(20, 2);
  Mesh mesh = looseAndShaken(sphere, 0.001);
  const NearWelding welding = weldNear(mesh, 0.004);  // the corners of a cube of 0.002 are 0.0035 apart
  EXPECT_EQ(welding.moved, 3 * sphere.triangles.size() - sphere.positions.size());
  EXPECT_LE(welding.largestMoveMm, 0.004);
  EXPECT_GT(welding.largestMoveMm, 0.001);
  dropUnused(mesh);
  EXPECT_EQ(mesh.positions.size(), sphere.positions.size());
  EXPECT_TRUE(shapes::isClosed(mesh));
}

TEST(WeldNear, KeepsVerticesThatAreFartherApart) {
  Mesh mesh = looseAndShaken(shapes::icosphere(20, 2), 0.001);
  const Mesh before = mesh;
  EXPECT_EQ(weldNear(mesh, 1e-7).moved, 0u);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(WeldNear, DoesNotWeldThroughAThinWall) {
  Mesh mesh = shapes::plate({20, 20}, 0.01, 4, 4);  // thinner than the tolerance, but closed
  const Mesh before = mesh;
  EXPECT_EQ(weldNear(mesh, 0.1).moved, 0u);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(WeldNear, NeverCollapsesATriangle) {
  Mesh mesh = looseAndShaken(shapes::icosphere(20, 1), 0.001);
  weldNear(mesh, 1000);
  for (const Triangle& t : mesh.triangles) EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
}

TEST(WeldNear, GivesUpOnVeryManyLooseTriangles) {
  // Each of the 36,000 corners lies within the tolerance of all others.
  Mesh mesh;
  for (std::uint32_t i = 0; i < 12'000; ++i) {
    const auto at = static_cast<float>(i) * 1e-6f;
    mesh.positions.insert(mesh.positions.end(), {{at, 0, 0}, {at, 1e-3f, 0}, {at, 0, 1e-3f}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  EXPECT_TRUE(weldNear(mesh, 1).cutShort);
}

TEST(WeldNear, KeepsPartsApart) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e-4f, 0, 0}, {0, -1, 0}, {1, 0, 1e-4f}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const std::vector<std::uint32_t> parts{0, 1};
  EXPECT_EQ(weldNear(mesh, 1e-3, parts).moved, 0u);
  EXPECT_EQ(weldNear(mesh, 1e-3).moved, 2u);
  EXPECT_EQ(mesh.triangles[1], (Triangle{0, 4, 1}));
}

}  // namespace
}  // namespace qrelief
