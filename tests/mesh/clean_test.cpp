// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/clean.h"

#include <algorithm>
#include <ctime>
#include <gtest/gtest.h>

#include "mesh/collinear.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

TEST(CleanTriangles, KeepsACleanMeshUnchanged) {
  Mesh mesh = shapes::icosphere(5, 2);
  const Mesh before = mesh;
  const Cleaning report = cleanTriangles(mesh);
  EXPECT_EQ(mesh.triangles, before.triangles);
  EXPECT_EQ(report.degenerate + report.duplicates, 0u);
}

TEST(CleanTriangles, DropsTrianglesThatUseAVertexTwice) {
  Mesh mesh = shapes::box({1, 1, 1});
  const std::vector<Triangle> before = mesh.triangles;
  mesh.triangles.insert(mesh.triangles.begin() + 3, {{1, 1, 2}, {5, 5, 5}});
  const Cleaning report = cleanTriangles(mesh);
  EXPECT_EQ(mesh.triangles, before);
  EXPECT_EQ(report.degenerate, 2u);
  EXPECT_EQ(*report.degenerateAt, mesh.positions[1]);
}

/// Returns a box whose upper edge along x has a vertex in its middle on the front face only. A triangle without area
/// over (0, middle, 1) closes the gap, as some CAD programs write it.
Mesh boxWithSliver() {
  Mesh mesh = shapes::box({2, 2, 2});
  // The front face z = +1 is (4, 5, 7), (4, 7, 6); its lower edge 4-5 gets the vertex 8.
  mesh.positions.push_back({0, -1, 1});
  std::erase(mesh.triangles, Triangle{4, 5, 7});
  mesh.triangles.insert(mesh.triangles.end(), {{4, 8, 7}, {8, 5, 7}, {8, 4, 5}});
  return mesh;
}

TEST(CleanTriangles, RepairsACollinearTriangleThatAClosedSurfaceNeeds) {
  Mesh mesh = boxWithSliver();
  ASSERT_TRUE(shapes::isClosed(mesh));
  const Cleaning report = cleanTriangles(mesh);
  EXPECT_EQ(report.degenerate, 1u);
  EXPECT_EQ(report.mended, 1u);
  EXPECT_TRUE(shapes::isClosed(mesh));
  EXPECT_EQ(mesh.triangles.size(), 14u);
  EXPECT_NEAR(signedVolume(mesh), 8, 1e-12);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) EXPECT_NE(triangleNormal(mesh, t), Vec3(0));
}

TEST(CleanTriangles, RepairsAChainOfCollinearTriangles) {
  Mesh mesh = shapes::box({16, 2, 2});
  std::erase(mesh.triangles, Triangle{4, 5, 7});
  // Vertices along the edge 4-5, fanned to 7 on the front face and to 4 by triangles without area.
  std::uint32_t previous = 4;
  for (int i = 1; i < 8; ++i) {
    mesh.positions.push_back({-8 + 2 * i, -1, 1});
    const auto next = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    mesh.triangles.push_back({previous, next, 7});
    if (previous != 4) mesh.triangles.push_back({previous, 4, next});
    previous = next;
  }
  mesh.triangles.push_back({previous, 5, 7});
  mesh.triangles.push_back({previous, 4, 5});
  ASSERT_TRUE(shapes::isClosed(mesh));
  const Cleaning report = cleanTriangles(mesh);
  EXPECT_EQ(report.degenerate, 7u);
  EXPECT_TRUE(shapes::isClosed(mesh));
  EXPECT_NEAR(signedVolume(mesh), 64, 1e-12);
}

TEST(CleanTriangles, DropsACollinearTriangleOnAClosedSurface) {
  Mesh mesh = shapes::box({2, 2, 2});
  const std::vector<Triangle> before = mesh.triangles;
  mesh.positions.push_back({0, -1, 1});
  mesh.triangles.push_back({4, 8, 5});
  const Cleaning report = cleanTriangles(mesh);
  EXPECT_EQ(mesh.triangles, before);
  EXPECT_EQ(report.degenerate, 1u);
  EXPECT_EQ(report.mended, 0u);
}

TEST(CleanTriangles, DropsAThinFlapOnAClosedSurface) {
  Mesh mesh = shapes::box({200, 200, 200});
  const std::vector<Triangle> before = mesh.triangles;
  mesh.positions.push_back({0, -100.0005f, 100});
  mesh.triangles.push_back({4, 8, 5});
  EXPECT_EQ(cleanTriangles(mesh).degenerate, 1u);
  EXPECT_EQ(mesh.triangles, before);
}

TEST(CleanTriangles, TerminatesIfCollinearSliversFlipEachOther) {
  // Found by fuzzing: all vertices except one are collinear.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, -7.9375f, 0}, {0, 0.8125f, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0.5f, 0}};
  mesh.triangles = {{0, 4, 1}, {0, 1, 2}, {0, 3, 2}, {1, 2, 3}, {0, 2, 1}, {0, 2, 1}, {4, 3, 2}, {5, 0, 4}};
  const std::clock_t before = std::clock();
  cleanTriangles(mesh);
  EXPECT_LT(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC, 0.1);
  for (const Triangle& t : mesh.triangles)
    EXPECT_FALSE(collinear(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]));
}

TEST(CleanTriangles, KeepsAWideFlap) {
  Mesh mesh = shapes::box({200, 200, 200});
  mesh.positions.push_back({0, -110, 100});
  mesh.triangles.push_back({4, 8, 5});
  EXPECT_EQ(cleanTriangles(mesh).degenerate, 0u);
  EXPECT_EQ(mesh.triangles.size(), 13u);
}

TEST(CleanTriangles, KeepsOneOfDuplicateTrianglesInAnyOrientation) {
  Mesh mesh = shapes::icosphere(5, 1);
  const std::vector<Triangle> before = mesh.triangles;
  const auto [a, b, c] = mesh.triangles[7];
  mesh.triangles.insert(mesh.triangles.end(), {{b, c, a}, {a, b, c}});
  mesh.triangles.push_back({mesh.triangles[9][1], mesh.triangles[9][0], mesh.triangles[9][2]});
  const Cleaning report = cleanTriangles(mesh);
  EXPECT_EQ(report.duplicates, 3u);
  EXPECT_EQ(mesh.triangles, before);
}

TEST(CleanTriangles, RemovesAWallWithoutThickness) {
  Mesh mesh = shapes::box({2, 2, 2});
  const std::vector<Triangle> before = mesh.triangles;
  mesh.positions.push_back({0, 0, 5});  // a fin on the box
  mesh.triangles.insert(mesh.triangles.end(), {{0, 5, 8}, {0, 8, 5}});
  const Cleaning report = cleanTriangles(mesh);
  EXPECT_EQ(report.duplicates, 2u);
  EXPECT_EQ(mesh.triangles, before);
}

TEST(CleanTriangles, KeepsTheFacesBetweenTwoSolids) {
  Mesh mesh = shapes::box({2, 2, 2});
  mesh.triangles.insert(mesh.triangles.end(), {{0, 5, 6}, {0, 6, 5}});  // cut off a corner, and close both pieces
  const Cleaning report = cleanTriangles(mesh);
  EXPECT_EQ(report.duplicates, 0u);
  EXPECT_EQ(mesh.triangles.size(), 14u);
  EXPECT_TRUE(shapes::isClosed(mesh));
}

}  // namespace
}  // namespace qrelief
