// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(SignedVolume, IsThatOfBoxAndTetrahedron) {
  EXPECT_NEAR(signedVolume(shapes::box({2, 3, 4})), 24, 1e-12);
  EXPECT_NEAR(signedVolume(shapes::tetrahedron(2)), 8 / (6 * std::sqrt(2.0)), 1e-7);  // float corners
}

TEST(SignedVolume, IsNegativeInsideOut) {
  EXPECT_NEAR(signedVolume(shapes::insideOut(shapes::box({2, 3, 4}))), -24, 1e-12);
}

TEST(SignedVolume, IsAccurateFarFromTheOrigin) {
  EXPECT_NEAR(signedVolume(shapes::translated(shapes::box({2, 4, 8}), {1e6, -1e6, 1e6})), 64, 1e-9);
}

TEST(SignedVolume, OfTorusAndCylinderIsThatOfTheirPolygons) {
  // A ring of n quads about the axis has sin(2π/n)/(2π/n) of the round ring's volume, and likewise for the tube's
  // m-gon.
  const auto polygonShare = [](int n) { return std::sin(2 * kPi / n) / (2 * kPi / n); };
  EXPECT_NEAR(signedVolume(shapes::cylinder(10, 5, 12)), kPi * 100 * 5 * polygonShare(12), 1e-4);
  EXPECT_NEAR(signedVolume(shapes::torus(10, 3, 400, 300)) / (2 * kPi * kPi * 10 * 9),
              polygonShare(400) * polygonShare(300), 1e-4);
}

TEST(TriangleNormal, IsUnitAndZeroWithoutArea) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {5, 0, 0}, {0, 7, 0}, {10, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
  EXPECT_EQ(triangleNormal(mesh, 0), Vec3(0, 0, 1));
  EXPECT_EQ(triangleNormal(mesh, 1), Vec3(0));
}

TEST(VertexNormals, OfASphereAreRadial) {
  const Mesh mesh = shapes::icosphere(20, 4);
  const std::vector<Vec3f> normals = vertexNormals(mesh);
  for (std::size_t v = 0; v < normals.size(); ++v)
    EXPECT_GT(glm::dot(Vec3(normals[v]), glm::normalize(Vec3(mesh.positions[v]))), 0.9999);
}

TEST(VertexNormals, OfABoxAreItsDiagonalsForAnyTriangulation) {
  // With angle weights each face contributes 90 degrees at a corner, whether it has one triangle there or two.
  const Mesh mesh = shapes::box({2, 2, 2});
  const std::vector<Vec3f> normals = vertexNormals(mesh);
  for (std::size_t v = 0; v < normals.size(); ++v)
    EXPECT_LT(glm::distance(Vec3(normals[v]), Vec3(mesh.positions[v]) / std::sqrt(3.0)), 1e-6);
}

TEST(VertexNormals, AreZeroForUnusedVertices) {
  Mesh mesh = shapes::box({1, 1, 1});
  mesh.positions.push_back({9, 9, 9});
  EXPECT_EQ(vertexNormals(mesh).back(), Vec3f(0));
}

TEST(BoundingBox, IsEmptyForAnEmptyMesh) { EXPECT_TRUE(boundingBox(Mesh{}).empty()); }

}  // namespace
}  // namespace qrelief
