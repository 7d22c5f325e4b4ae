// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/orient.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

struct Oriented {
  Mesh mesh;
  Adjacency adjacency;
  Consistency consistency;
  Outwardness outwardness;
};

Oriented orient(Mesh mesh) {
  Oriented result{std::move(mesh), {}, {}, {}};
  result.adjacency = buildAdjacency(result.mesh.triangles);
  result.consistency = makeConsistent(result.mesh.triangles, result.adjacency);
  result.outwardness = orientOutwards(result.mesh, result.adjacency, result.consistency);
  return result;
}

void turnSome(Mesh& mesh, std::size_t step) {
  for (std::size_t t = 0; t < mesh.triangles.size(); t += step) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
}

TEST(MakeConsistent, KeepsAConsistentMeshUnchanged) {
  const Mesh mesh = shapes::torus(10, 3, 12, 9);
  const Oriented result = orient(mesh);
  EXPECT_EQ(result.mesh.triangles, mesh.triangles);
  EXPECT_EQ(result.consistency.turned, 0u);
  EXPECT_FALSE(result.consistency.oneSided);
}

TEST(MakeConsistent, FlipsTheSmallerPartAndKeepsTheAdjacencyValid) {
  Mesh mesh = shapes::icosphere(5, 2);
  const double volume = signedVolume(mesh);
  turnSome(mesh, 3);
  const Oriented result = orient(mesh);
  EXPECT_EQ(result.consistency.turned, (mesh.triangles.size() + 2) / 3);
  EXPECT_DOUBLE_EQ(signedVolume(result.mesh), volume);
  EXPECT_EQ(result.adjacency, buildAdjacency(result.mesh.triangles));
  EXPECT_EQ(result.outwardness.insideOut, 0u);
}

TEST(MakeConsistent, NumbersShellsByTheirFirstTriangle) {
  const Mesh two = shapes::together(shapes::box({1, 1, 1}), shapes::translated(shapes::box({1, 1, 1}), {5, 0, 0}));
  const Oriented result = orient(two);
  EXPECT_EQ(result.consistency.shells.count, 2u);
  EXPECT_EQ(result.consistency.shells.of.front(), 0u);
  EXPECT_EQ(result.consistency.shells.of.back(), 1u);
}

TEST(MakeConsistent, ReportsWhereASurfaceIsOneSided) {
  // A Möbius strip of five triangles over five vertices [Möbius 1886].
  std::vector<Triangle> strip;
  for (std::uint32_t i = 0; i < 5; ++i) strip.push_back({i, (i + 1) % 5, (i + 2) % 5});
  Adjacency adjacency = buildAdjacency(strip);
  EXPECT_TRUE(makeConsistent(strip, adjacency).oneSided);
}

TEST(OrientOutwards, FlipsAnInsideOutShell) {
  const Mesh mesh = shapes::icosphere(5, 2);
  const Oriented result = orient(shapes::insideOut(mesh));
  EXPECT_EQ(result.outwardness.insideOut, 1u);
  EXPECT_DOUBLE_EQ(signedVolume(result.mesh), signedVolume(mesh));
  EXPECT_EQ(result.adjacency, buildAdjacency(result.mesh.triangles));
}

TEST(OrientOutwards, KeepsACavityUnchanged) {
  const Mesh hollow = shapes::together(shapes::box({4, 4, 4}), shapes::insideOut(shapes::box({2, 2, 2})));
  const Oriented result = orient(hollow);
  EXPECT_EQ(result.mesh.triangles, hollow.triangles);
  EXPECT_EQ(result.outwardness.cavities, 1u);
  EXPECT_EQ(result.outwardness.insideOut, 0u);
}

TEST(OrientOutwards, FlipsAnInsideOutHollowBodyAsAWhole) {
  const Mesh hollow = shapes::together(shapes::box({4, 4, 4}), shapes::insideOut(shapes::box({2, 2, 2})));
  const Oriented result = orient(shapes::insideOut(hollow));
  EXPECT_NEAR(signedVolume(result.mesh), 64 - 8, 1e-12);
  EXPECT_EQ(result.outwardness.insideOut, 2u);
  EXPECT_EQ(result.outwardness.cavities, 1u);
}

TEST(OrientOutwards, FlipsAnInsideOutShellAroundACorrectCavity) {
  const Oriented result =
      orient(shapes::together(shapes::insideOut(shapes::box({4, 4, 4})), shapes::insideOut(shapes::box({2, 2, 2}))));
  EXPECT_NEAR(signedVolume(result.mesh), 64 - 8, 1e-12);
  EXPECT_EQ(result.outwardness.insideOut, 1u);
}

TEST(OrientOutwards, KeepsASolidInsideASolidAndReportsIt) {
  const Mesh nested = shapes::together(shapes::box({4, 4, 4}), shapes::box({2, 2, 2}));
  const Oriented result = orient(nested);
  EXPECT_EQ(result.mesh.triangles, nested.triangles);
  EXPECT_EQ(result.outwardness.nestedSolids, 1u);
  EXPECT_EQ(result.outwardness.cavities, 0u);
}

TEST(OrientOutwards, MakesAMixedInnerShellACavity) {
  Mesh inner = shapes::icosphere(1, 1);
  turnSome(inner, 3);
  const Oriented result = orient(shapes::together(shapes::box({4, 4, 4}), inner));
  EXPECT_NEAR(signedVolume(result.mesh), 64 - signedVolume(shapes::icosphere(1, 1)), 1e-9);
}

TEST(OrientOutwards, KeepsOpenShellsUnchanged) {
  Mesh open = shapes::insideOut(shapes::box({1, 1, 1}));
  open.triangles.pop_back();
  EXPECT_EQ(orient(open).mesh.triangles, open.triangles);
}

}  // namespace
}  // namespace qrelief
