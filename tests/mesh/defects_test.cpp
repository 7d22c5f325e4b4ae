// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

Defects defectsOf(const Mesh& mesh) {
  const EdgeTable edges = buildEdgeTable(mesh.triangles);
  return findDefects(mesh, edges, buildAdjacency(mesh.triangles, edges));
}

TEST(FindDefects, FindsNoneInClosedManifolds) {
  for (const Mesh& mesh : {shapes::tetrahedron(1), shapes::torus(10, 3, 7, 5), shapes::plate({9, 9}, 2, 4, 3)}) {
    const Defects defects = defectsOf(mesh);
    EXPECT_EQ(defects.openEdges + defects.nonManifoldEdges + defects.nonManifoldVertices, 0u);
  }
}

TEST(FindDefects, CountsOpenEdgesAndHoles) {
  Mesh mesh = shapes::icosphere(5, 2);
  const Vec3 at = (mesh.corner(0, 0) + mesh.corner(0, 1) + mesh.corner(0, 2)) / 3.0;
  mesh.triangles.erase(mesh.triangles.begin() + 200);
  mesh.triangles.erase(mesh.triangles.begin());
  const Defects defects = defectsOf(mesh);
  EXPECT_EQ(defects.openEdges, 6u);
  EXPECT_EQ(defects.holes, 2u);
  EXPECT_LT(glm::distance(defects.openAt, at), 2);
}

TEST(FindDefects, CountsEdgesOfMoreThanTwoTriangles) {
  // Two boxes share an edge, so four triangles meet at it.
  Mesh mesh = shapes::box({2, 2, 2});
  const Mesh other = shapes::translated(shapes::box({2, 2, 2}), {2, 2, 0});
  const std::array<std::uint32_t, 8> index{3, 8, 9, 10, 7, 11, 12, 13};  // corners 0 and 4 become 3 and 7
  for (const std::size_t v : {1, 2, 3, 5, 6, 7}) mesh.positions.push_back(other.positions[v]);
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({index[a], index[b], index[c]});
  const Defects defects = defectsOf(mesh);
  EXPECT_EQ(defects.nonManifoldEdges, 1u);
  EXPECT_EQ(defects.nonManifoldEdgeAt, Vec3(1, 1, 0));
  EXPECT_EQ(defects.openEdges, 0u);
}

TEST(FindDefects, CountsVerticesSharedByTwoFans) {
  // Two tetrahedra touch in vertex 0.
  Mesh mesh = shapes::tetrahedron(2);
  const Mesh other = shapes::translated(mesh, 2.0 * Vec3(mesh.positions[0]));
  for (std::size_t v = 0; v < 3; ++v) mesh.positions.push_back(other.positions[v]);
  for (const auto& [a, b, c] : other.triangles) {
    const std::array<std::uint32_t, 4> index{4, 5, 6, 0};
    mesh.triangles.push_back({index[a], index[b], index[c]});
  }
  const Defects defects = defectsOf(mesh);
  EXPECT_EQ(defects.nonManifoldVertices, 1u);
  EXPECT_EQ(defects.nonManifoldVertexAt, Vec3(mesh.positions[0]));
}

}  // namespace
}  // namespace qrelief
