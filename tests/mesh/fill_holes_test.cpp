// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/fill_holes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "mesh/self_intersection.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

HoleFilling fill(Mesh& mesh, double maxDiameterMm) {
  auto filling = fillHoles(mesh, maxDiameterMm);
  EXPECT_TRUE(filling);
  return filling.value_or(HoleFilling{});
}

/// Removes the triangles whose corners all lie above a height.
Mesh cutAbove(Mesh mesh, float z) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.positions[v].z > z; });
  });
  return mesh;
}

TEST(FillHoles, ClosesAFlatHoleWithoutChangingTheVolume) {
  // The upper side of a block: a loop of 24 edges in one plane, 20·√2 across.
  Mesh mesh = cutAbove(shapes::plate({20, 20}, 5, 6, 6), -1);
  const double missing = 72;
  const Mesh whole = shapes::plate({20, 20}, 5, 6, 6);
  ASSERT_EQ(mesh.triangles.size() + static_cast<std::size_t>(missing), whole.triangles.size());
  const HoleFilling filling = fill(mesh, 30);
  EXPECT_EQ(filling.filled, 1u);
  EXPECT_NEAR(filling.largestFilledMm, 20 * std::sqrt(2.0), 1e-5);
  EXPECT_EQ(filling.beside.size(), 22u);
  EXPECT_TRUE(shapes::isClosed(mesh));
  EXPECT_NEAR(signedVolume(mesh), 2000, 1e-3);
}

TEST(FillHoles, LeavesALargeOpeningAndMeasuresIt) {
  Mesh mesh = cutAbove(shapes::plate({20, 20}, 5, 6, 6), -1);
  const Mesh before = mesh;
  const HoleFilling filling = fill(mesh, 28);
  EXPECT_EQ(filling.filled, 0u);
  EXPECT_EQ(filling.tooLarge, 1u);
  EXPECT_EQ(filling.largestLeftEdges, 24u);
  EXPECT_NEAR(filling.largestLeftMm, 20 * std::sqrt(2.0), 1e-5);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(FillHoles, FillsAMissingTriangleOfAnySize) {
  const Mesh box = shapes::box({200, 100, 50});
  for (std::size_t t = 0; t < box.triangles.size(); ++t) {
    Mesh mesh = box;
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    EXPECT_EQ(fill(mesh, 1).filled, 1u);
    EXPECT_TRUE(shapes::isClosed(mesh));
    EXPECT_NEAR(signedVolume(mesh), signedVolume(box), 1e-6);
  }
}

TEST(FillHoles, ClosesACurvedHoleWithoutCrossingAnything) {
  Mesh mesh = cutAbove(shapes::bumpySphere(20, 1, 3, 4), 18);
  ASSERT_FALSE(shapes::isClosed(mesh));
  EXPECT_EQ(fill(mesh, 40).filled, 1u);
  EXPECT_TRUE(shapes::isClosed(mesh));
  EXPECT_TRUE(findSelfIntersections(mesh)->empty());
}

TEST(FillHoles, ClosesTwoHolesThatShareAVertex) {
  Mesh mesh = shapes::icosphere(10, 2);
  const std::uint32_t shared = 20;
  std::vector<std::uint32_t> around;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (std::count(mesh.triangles[t].begin(), mesh.triangles[t].end(), shared)) around.push_back(t);
  // Removes the first triangle and one that shares only the vertex with it.
  const Triangle first = mesh.triangles[around[0]];
  const auto apart = std::find_if(around.begin() + 1, around.end(), [&](std::uint32_t t) {
    return std::count_if(first.begin(), first.end(), [&](std::uint32_t v) {
             return std::count(mesh.triangles[t].begin(), mesh.triangles[t].end(), v) > 0;
           }) == 1;
  });
  ASSERT_NE(apart, around.end());
  mesh.triangles.erase(mesh.triangles.begin() + *apart);
  mesh.triangles.erase(mesh.triangles.begin() + around[0]);
  EXPECT_EQ(fill(mesh, 10).filled, 2u);
  EXPECT_TRUE(shapes::isClosed(mesh));
  EXPECT_NEAR(signedVolume(mesh), signedVolume(shapes::icosphere(10, 2)), 1e-9);
}

TEST(FillHoles, DoesNotDoubleALooseTriangle) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const HoleFilling filling = fill(mesh, 10);
  EXPECT_EQ(filling.filled, 0u);
  EXPECT_EQ(filling.blocked, 1u);
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(FillHoles, DiscardsAPatchThatWouldCrossTheSurface) {
  // A rod passes through the open top of a block.
  const Mesh block = cutAbove(shapes::plate({20, 20}, 5, 6, 6), -1);
  Mesh mesh = shapes::together(block, shapes::box({1, 1, 8}));
  const Mesh before = mesh;
  const HoleFilling filling = fill(mesh, 30);
  EXPECT_EQ(filling.filled, 0u);
  EXPECT_EQ(filling.blocked, 1u);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(FillHoles, SkipsAVertexOfVeryManyLooseTriangles) {
  Mesh mesh;
  mesh.positions.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < 300'000; ++i) {
    const auto at = static_cast<float>(i);
    mesh.positions.insert(mesh.positions.end(), {{at, 1, 0}, {at, 1, 1}});
    mesh.triangles.push_back({0, 2 * i + 1, 2 * i + 2});
  }
  const auto filling = fillHoles(mesh, 1e9);
  ASSERT_TRUE(filling);
  EXPECT_EQ(filling->filled + filling->blocked + filling->tooLarge, 0u);
}

TEST(FillHoles, KeepsAClosedMeshUnchanged) {
  Mesh mesh = shapes::box({1, 1, 1});
  EXPECT_EQ(fill(mesh, 10).filled, 0u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
}

}  // namespace
}  // namespace qrelief
