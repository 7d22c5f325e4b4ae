// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/untangle.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "math/tolerance.h"
#include "mesh/crossing_segments.h"
#include "mesh/self_intersection.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

/// Returns two boxes, the second pushed through the first's upper face.
Mesh crossingBoxes() {
  return shapes::together(shapes::box({4, 4, 4}), shapes::translated(shapes::box({1, 1, 2}), {0.1, 0.2, 2}));
}

std::size_t crossingsOf(const Mesh& mesh) { return findSelfIntersections(mesh)->size(); }

void expectUntouched(Mesh mesh, std::size_t pairs) {
  const Mesh before = mesh;
  const auto result = untangle(mesh);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->pairs, pairs);
  EXPECT_FALSE(result->mended);
  EXPECT_EQ(result->moved, 0u);
  EXPECT_EQ(result->largestMoveMm, 0);
  EXPECT_EQ(mesh.positions, before.positions);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(Untangle, SeparatesATangleByMovingOneVertexOnly) {
  Mesh mesh = shapes::tangledSphere();
  const Mesh before = mesh;
  const auto result = untangle(mesh);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->pairs, 5u);
  EXPECT_FALSE(result->atLeast);
  EXPECT_TRUE(result->mended);
  EXPECT_EQ(result->at, crossingPoint(before, findSelfIntersections(before)->front()));
  EXPECT_EQ(crossingsOf(mesh), 0u);
  EXPECT_EQ(mesh.triangles, before.triangles);
  ASSERT_EQ(result->moved, 1u);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v] == before.positions[v]) continue;
    EXPECT_EQ(result->largestMoveMm, glm::distance(Vec3(mesh.positions[v]), Vec3(before.positions[v])));
    EXPECT_LE(result->largestMoveMm, kMaxRepairMoveMm);
  }
}

TEST(Untangle, SeparatesSeveralTanglesIndependently) {
  const Mesh one = shapes::tangledSphere();
  Mesh alone = one;
  ASSERT_TRUE(untangle(alone)->mended);
  Mesh two = shapes::together(one, shapes::translated(one, {32, 0, 0}));
  const auto result = untangle(two);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->mended);
  EXPECT_EQ(result->pairs, 10u);
  EXPECT_EQ(result->moved, 2u);
  EXPECT_EQ(crossingsOf(two), 0u);
  EXPECT_TRUE(std::equal(alone.positions.begin(), alone.positions.end(), two.positions.begin()));
}

TEST(Untangle, MovesNoVertexFartherThanAPrinterShows) {
  Mesh larger = shapes::tangledSphere();
  for (Vec3f& p : larger.positions) p *= 1024;
  expectUntouched(larger, 5);
}

TEST(Untangle, KeepsASpikeThatComesOutOnTheOtherSide) {
  // Only far from their crossing are the spike's triangles joined with those that they cross.
  Mesh spiked = shapes::icosphere(10, 4);
  spiked.positions[100] *= -1.2f;
  const std::size_t pairs = crossingsOf(spiked);
  EXPECT_GT(pairs, 0u);
  EXPECT_LT(pairs, 100u);
  expectUntouched(spiked, pairs);
}

TEST(Untangle, KeepsACleanMeshUnchanged) { expectUntouched(shapes::bumpySphere(50, 3, 4, 3), 0); }

TEST(Untangle, KeepsOverlappingShells) {
  const Mesh sphere = shapes::icosphere(10, 4);
  expectUntouched(shapes::together(sphere, shapes::translated(sphere, {7, 1, 2})), 0);
  expectUntouched(crossingBoxes(), 0);
}

TEST(Untangle, MovesNothingIfOneOfSeveralTanglesCannotBeSeparated) {
  Mesh larger = shapes::tangledSphere();
  for (Vec3f& p : larger.positions) p *= 1024;
  expectUntouched(shapes::together(shapes::tangledSphere(), larger), 10);
}

TEST(Untangle, ReportsThatItStoppedCounting) {
  const Mesh plate = shapes::plate({30, 30}, 4, 24, 24);
  Mesh twice = shapes::together(plate, shapes::translated(plate, {0.125, 0.125, 0}));
  const auto second = static_cast<std::uint32_t>(plate.positions.size());
  for (Triangle& t : twice.triangles) std::replace(t.begin(), t.end(), second, 0u);  // one shell at a vertex
  const auto result = untangle(twice);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->pairs, 1000u);
  EXPECT_TRUE(result->atLeast);
  EXPECT_FALSE(result->mended);
}

}  // namespace
}  // namespace qrelief
