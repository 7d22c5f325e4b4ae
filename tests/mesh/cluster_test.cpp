// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cluster.h"

#include <gtest/gtest.h>
#include <numbers>

#include "support/shapes.h"

namespace qrelief {
namespace {

ClusteredMesh clustered(const Mesh& mesh, double cellMm) { return clusterVertices(mesh, vertexNormals(mesh), cellMm); }

TEST(ClusterVertices, KeepsTheShapeOfADenseSphereWithAFewPercentOfItsFacets) {
  const Mesh sphere = shapes::icosphere(50, 6);
  const ClusteredMesh coarse = clustered(sphere, 5);
  EXPECT_LT(coarse.mesh.triangles.size(), sphere.triangles.size() / 20);
  const double volume = 4.0 / 3 * std::numbers::pi * 50 * 50 * 50;
  EXPECT_NEAR(signedVolume(coarse.mesh), volume, 0.02 * volume);
  ASSERT_EQ(coarse.clusterOf.size(), sphere.positions.size());
  for (std::size_t v = 0; v < sphere.positions.size(); ++v)
    EXPECT_LE(glm::distance(Vec3(sphere.positions[v]), Vec3(coarse.mesh.positions[coarse.clusterOf[v]])),
              5 * std::numbers::sqrt3);
}

TEST(ClusterVertices, KeepsTheTwoSidesOfAThinWallApart) {
  // The wall is 1 mm thick and the cells are 8 mm, so every cell except the outermost holds vertices of both sides.
  const Mesh wall =
      shapes::together(shapes::plate({80, 80}, 1, 40, 40),
                       shapes::translated(shapes::insideOut(shapes::plate({80, 80}, 1, 40, 40)), {0, 0, 2}));
  const ClusteredMesh coarse = clustered(wall, 8);
  for (std::size_t v = 0; v < wall.positions.size(); ++v) {
    const Vec3f p = wall.positions[v];
    if (std::abs(p.x) > 30 || std::abs(p.y) > 30) continue;
    EXPECT_EQ(coarse.mesh.positions[coarse.clusterOf[v]].z, p.z);
  }
}

TEST(ClusterVertices, DropsFacetsThatEndUpBackToBack) {
  // A flat fin on a large facet: its tip and its two sides collapse onto its base edge.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {100, 0, 0}, {0, 100, 0}, {50, -0.1f, 0.1f}, {50, -0.1f, 0.2f}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 4, 0}};
  const std::vector<Vec3f> up(5, Vec3f(0, 0, 1));
  const ClusteredMesh coarse = clusterVertices(mesh, up, 1);
  EXPECT_EQ(coarse.clusterOf[3], coarse.clusterOf[4]);
  EXPECT_EQ(coarse.mesh.triangles.size(), 1u);
}

TEST(ClusterVertices, KeepsAMeshUnchangedIfEveryVertexHasItsOwnCell) {
  const Mesh sphere = shapes::icosphere(10, 2);
  const ClusteredMesh same = clustered(sphere, 1e-6);
  EXPECT_EQ(same.mesh.triangles.size(), sphere.triangles.size());
  for (std::size_t v = 0; v < sphere.positions.size(); ++v)
    EXPECT_EQ(same.mesh.positions[same.clusterOf[v]], sphere.positions[v]);
}

}  // namespace
}  // namespace qrelief
