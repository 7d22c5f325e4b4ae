// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/t_junctions.h"

#include <gtest/gtest.h>

#include "mesh/topology.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

std::size_t openEdges(const Mesh& mesh) {
  const EdgeTable edges = buildEdgeTable(mesh.triangles);
  std::size_t open = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) open += edges.at(e).size() == 1;
  return open;
}

/// Returns a box of edge 2 whose edge from vertex 4 to 5 has one or more extra vertices on the front face only, `gap`
/// off it.
Mesh boxWithJunctions(int count, float gap) {
  Mesh mesh = shapes::box({2, 2, 2});
  std::erase(mesh.triangles, Triangle{4, 5, 7});
  std::uint32_t previous = 4;
  for (int i = 1; i <= count; ++i) {
    mesh.positions.push_back({-1 + 2.0f * static_cast<float>(i) / static_cast<float>(count + 1), -1 - gap, 1});
    const auto next = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    mesh.triangles.push_back({previous, next, 7});
    previous = next;
  }
  mesh.triangles.push_back({previous, 5, 7});
  return mesh;
}

TEST(SplitAtTJunctions, SplitsAnEdgeWithVeryManyVertices) {
  // All slivers next to the edge share an apex. The search compares the boxes of their edges, not of the slivers.
  Mesh mesh = boxWithJunctions(50'000, 0);
  const TJunctionSplit split = splitAtTJunctions(mesh, 1e-6);
  EXPECT_EQ(split.vertices, 50'000u);
  EXPECT_FALSE(split.cutShort);
  EXPECT_EQ(openEdges(mesh), 0u);
}

TEST(SplitAtTJunctions, GivesUpOnVeryManyLooseTriangles) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < 12'000; ++i) {
    const auto at = static_cast<float>(i) * 1e-3f;
    mesh.positions.insert(mesh.positions.end(), {{at, 0, 0}, {100 + at, 100, 100}, {-at, 50, 0}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  EXPECT_TRUE(splitAtTJunctions(mesh, 1).cutShort);
}

TEST(SplitAtTJunctions, SplitsATriangleAtOneOrSeveralVertices) {
  for (const int count : {1, 2, 5}) {
    Mesh mesh = boxWithJunctions(count, 0);
    const std::size_t before = mesh.triangles.size();
    ASSERT_EQ(openEdges(mesh), static_cast<std::size_t>(count) + 2);
    const TJunctionSplit split = splitAtTJunctions(mesh, 1e-5);
    EXPECT_EQ(split.vertices, static_cast<std::size_t>(count));
    EXPECT_EQ(split.largestGapMm, 0);
    EXPECT_EQ(openEdges(mesh), 0u);
    EXPECT_EQ(mesh.triangles.size(), before + static_cast<std::size_t>(count));
    EXPECT_EQ(split.origin.size(), mesh.triangles.size());
    EXPECT_NEAR(signedVolume(mesh), 8, 1e-6);
  }
}

TEST(SplitAtTJunctions, ClosesAGapWithinTheToleranceOnly) {
  Mesh mesh = boxWithJunctions(1, 1e-3f);
  EXPECT_EQ(splitAtTJunctions(mesh, 0.5e-3).vertices, 0u);
  EXPECT_EQ(openEdges(mesh), 3u);
  const TJunctionSplit split = splitAtTJunctions(mesh, 2e-3);
  EXPECT_EQ(split.vertices, 1u);
  EXPECT_NEAR(split.largestGapMm, 1e-3, 1e-6);
  EXPECT_EQ(openEdges(mesh), 0u);
}

TEST(SplitAtTJunctions, DoesNotSplitWithoutClosingAnOpenEdge) {
  // The corner of a loose triangle lies on the edge of another triangle.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, -1, 0}, {2, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const Mesh before = mesh;
  const TJunctionSplit split = splitAtTJunctions(mesh, 1e-3);
  EXPECT_EQ(split.vertices, 0u);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(SplitAtTJunctions, KeepsAClosedMeshUnchanged) {
  Mesh mesh = shapes::icosphere(5, 2);
  const Mesh before = mesh;
  EXPECT_EQ(splitAtTJunctions(mesh, 1).vertices, 0u);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

}  // namespace
}  // namespace qrelief
