// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/touching_shells.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "mesh/weld.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

Mesh weldedTogether(const Mesh& a, const Mesh& b) {
  const Mesh both = shapes::together(a, b);
  return welded(both.positions, both.triangles);
}

std::size_t separate(Mesh& mesh) { return separateTouchingShells(mesh, buildEdgeTable(mesh.triangles)); }

std::vector<std::array<Vec3, 3>> cornersOf(const Mesh& mesh) {
  std::vector<std::array<Vec3, 3>> corners;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    corners.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
  return corners;
}

TEST(TouchingShells, LeavesAClosedSurfaceAlone) {
  Mesh mesh = shapes::torus(5, 1, 20, 8);
  const Mesh before = mesh;
  EXPECT_EQ(separate(mesh), 0u);
  EXPECT_EQ(mesh.triangles, before.triangles);
  EXPECT_EQ(mesh.positions, before.positions);
}

TEST(TouchingShells, AreClosedAgainWhereTwoBoxesShareAFace) {
  Mesh mesh = weldedTogether(shapes::box({2, 2, 2}), shapes::translated(shapes::box({2, 2, 2}), {0, 0, 2}));
  ASSERT_EQ(mesh.positions.size(), 12u);
  const auto before = cornersOf(mesh);
  EXPECT_EQ(separate(mesh), 4u);
  EXPECT_EQ(mesh.positions.size(), 16u);
  EXPECT_TRUE(shapes::isClosed(mesh));
  EXPECT_EQ(cornersOf(mesh), before);
  for (std::size_t t = 0; t < 12; ++t)  // of the first box
    for (const std::uint32_t v : mesh.triangles[t])
      for (std::size_t u = 12; u < 24; ++u)
        for (const std::uint32_t w : mesh.triangles[u]) EXPECT_NE(v, w);
}

TEST(TouchingShells, AreClosedAgainWhereTwoBoxesShareAnEdge) {
  Mesh mesh = weldedTogether(shapes::box({2, 2, 2}), shapes::translated(shapes::box({2, 2, 2}), {2, 0, 2}));
  EXPECT_EQ(separate(mesh), 2u);
  EXPECT_EQ(mesh.positions.size(), 16u);
  EXPECT_TRUE(shapes::isClosed(mesh));
}

TEST(TouchingShells, AreClosedAgainWhereFourBoxesMeetAtOneEdge) {
  Mesh mesh = shapes::box({2, 2, 2});
  for (const Vec3 offset : {Vec3{2, 0, 0}, Vec3{0, 2, 0}, Vec3{2, 2, 0}})
    mesh = weldedTogether(mesh, shapes::translated(shapes::box({2, 2, 2}), offset));
  separate(mesh);
  EXPECT_EQ(mesh.positions.size(), 32u);
  EXPECT_TRUE(shapes::isClosed(mesh));
}

TEST(TouchingShells, HaveAVertexOfTheirOwnWhereTwoBoxesShareACorner) {
  Mesh mesh = weldedTogether(shapes::box({2, 2, 2}), shapes::translated(shapes::box({2, 2, 2}), {2, 2, 2}));
  ASSERT_EQ(mesh.positions.size(), 15u);
  EXPECT_EQ(separate(mesh), 1u);
  EXPECT_TRUE(shapes::isClosed(mesh));
}

TEST(TouchingShells, AreFoundAtAnyAngleOfTheSharedFace) {
  for (int i = 0; i < 24; ++i) {
    const double angle = i * 0.3, c = std::cos(angle), s = std::sin(angle);
    Mesh mesh = weldedTogether(shapes::box({2, 2, 2}), shapes::translated(shapes::box({2, 2, 2}), {2, 0, 0}));
    for (Vec3f& p : mesh.positions)
      p = Vec3f(Vec3(c * p.x - s * p.y, s * p.x * 0.8 + c * p.y * 0.8 - 0.6 * p.z,
                     s * p.x * 0.6 + c * p.y * 0.6 + 0.8 * p.z));
    EXPECT_EQ(separate(mesh), 4u) << angle;
    EXPECT_TRUE(shapes::isClosed(mesh)) << angle;
  }
}

TEST(TouchingShells, StayTogetherWhereATriangleFacesTheWrongWay) {
  Mesh mesh =
      weldedTogether(shapes::box({2, 2, 2}), shapes::insideOut(shapes::translated(shapes::box({2, 2, 2}), {2, 0, 2})));
  const std::vector<Triangle> before = mesh.triangles;
  EXPECT_EQ(separate(mesh), 0u);
  EXPECT_EQ(mesh.triangles, before);
}

TEST(TouchingShells, AreNoCopiesOfOneShell) {
  Mesh mesh = weldedTogether(shapes::box({2, 2, 2}), shapes::box({2, 2, 2}));
  EXPECT_EQ(separate(mesh), 0u);
}

TEST(TouchingShells, HaveVolume) {  // a wall without thickness on a box is no shell
  Mesh mesh = shapes::box({2, 2, 2});
  mesh.positions.push_back({0, 0, 5});
  const Triangle& top = mesh.triangles[0];
  const std::uint32_t apex = 8, a = top[0], b = top[1];
  mesh.triangles.insert(mesh.triangles.end(), {{a, b, apex}, {b, a, apex}});
  EXPECT_EQ(separate(mesh), 0u);
}

}  // namespace
}  // namespace qrelief
