// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ray.h"

#include <cmath>
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

TEST(FirstHit, FindsTheNearerSideOfABoxAndMeasuresInMillimetres) {
  const Mesh mesh = shapes::box({2, 4, 6});
  const auto hit = firstHit(mesh, {10, 0.3, 0.7}, {-5, 0, 0});
  ASSERT_TRUE(hit);
  EXPECT_LT(glm::distance(hit->position, {1, 0.3, 0.7}), 1e-12);
  EXPECT_NEAR(hit->distance, 9, 1e-12);
  EXPECT_EQ(triangleNormal(mesh, hit->triangle), Vec3(1, 0, 0));
}

TEST(FirstHit, HitsTrianglesFromBehind) {
  const auto hit = firstHit(shapes::box({2, 4, 6}), {0, 0.1, 0.2}, {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 2.8, 1e-12);
}

TEST(FirstHit, IsEmptyBehindTheOriginAndBesideTheMesh) {
  const Mesh mesh = shapes::box({2, 2, 2});
  EXPECT_FALSE(firstHit(mesh, {10, 0, 0}, {1, 0, 0}));
  EXPECT_FALSE(firstHit(mesh, {10, 1.0001, 0}, {-1, 0, 0}));
  EXPECT_FALSE(firstHit(Mesh{}, {0, 0, 0}, {0, 0, 1}));
}

TEST(FirstHit, NeverSlipsThroughASharedEdgeOrVertex) {
  const Mesh mesh = shapes::icosphere(10, 3);
  const auto expectHit = [&](Vec3 target) {
    const Vec3 eye = target * 3.0 + Vec3(0.37, -0.11, 0.23);
    const auto hit = firstHit(mesh, eye, target - eye);
    ASSERT_TRUE(hit);
    EXPECT_LT(glm::distance(hit->position, target), 1e-9);
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      expectHit(mesh.corner(t, k));
      for (const double s : {0.5, 0.1}) expectHit(glm::mix(mesh.corner(t, k), mesh.corner(t, (k + 1) % 3), s));
    }
}

TEST(FirstHit, ReturnsTheLowerTriangleInATie) {
  Mesh mesh = shapes::box({2, 2, 2});
  mesh.triangles.insert(mesh.triangles.end(), mesh.triangles.begin(), mesh.triangles.begin() + 12);
  EXPECT_LT(firstHit(mesh, {0.2, 0.3, 9}, {0, 0, -1})->triangle, 12u);
}

TEST(ClosestPoint, IsOnTheFaceEdgeOrCornerOfABox) {
  const Mesh mesh = shapes::box({2, 2, 2});
  EXPECT_EQ(closestPoint(mesh, {0.25, 0.5, 7})->position, Vec3(0.25, 0.5, 1));
  EXPECT_EQ(closestPoint(mesh, {0.25, 4, 5})->position, Vec3(0.25, 1, 1));
  EXPECT_EQ(closestPoint(mesh, {4, 4, 4})->position, Vec3(1, 1, 1));
  EXPECT_NEAR(closestPoint(mesh, {4, 4, 4})->distance, std::sqrt(27.0), 1e-12);
  EXPECT_NEAR(closestPoint(mesh, {0.25, 0, 0})->distance, 0.75, 1e-12);
}

TEST(ClosestPoint, OfASphereLiesTowardsTheQuery) {
  const Mesh mesh = shapes::icosphere(10, 4);
  for (const Vec3 query : {Vec3(20, 3, -5), Vec3(-1, 2, 0.5), Vec3(0, 0, 30)}) {
    const auto closest = closestPoint(mesh, query);
    EXPECT_NEAR(closest->distance, std::abs(glm::length(query) - 10), 0.03);
    EXPECT_NEAR(glm::distance(closest->position, query), closest->distance, 1e-12);
  }
}

TEST(ClosestPoint, ReturnsTheLowerTriangleInATie) {
  const Mesh mesh = shapes::box({2, 2, 2});
  const auto closest = closestPoint(mesh, {3, 3, 3});
  std::uint32_t lowest = 0;
  while (mesh.corner(lowest, 0) != Vec3(1) && mesh.corner(lowest, 1) != Vec3(1) && mesh.corner(lowest, 2) != Vec3(1))
    ++lowest;
  EXPECT_EQ(closest->triangle, lowest);
}

TEST(ClosestPoint, OfAnEmptyMeshIsEmpty) { EXPECT_FALSE(closestPoint(Mesh{}, {0, 0, 0})); }

TEST(SurfaceNormalAt, IsTheFacetNormalWithinAFaceAndOnItsDiagonal) {
  const Mesh mesh = shapes::box({20, 20, 20});
  for (const Vec3 query : {Vec3(3, -2, 10), Vec3(0, 0, 10), Vec3(4, 4, 10), Vec3(4, -4, 10)})
    EXPECT_LT(glm::distance(surfaceNormalAt(mesh, *closestPoint(mesh, query)), Vec3(0, 0, 1)), 1e-12);
}

TEST(SurfaceNormalAt, IsTheMeanOfBothFacesOnAnEdge) {
  const Mesh mesh = shapes::box({20, 20, 20});
  const Vec3 expected = glm::normalize(Vec3(1, 0, 1));
  EXPECT_LT(glm::distance(surfaceNormalAt(mesh, *closestPoint(mesh, {10, 3, 10})), expected), 1e-12);
}

TEST(SurfaceNormalAt, IsTheMeanOfTheThreeFacesAtACornerForAnyTriangulation) {
  const Mesh mesh = shapes::box({20, 20, 20});
  for (const Vec3 corner : {Vec3(10, 10, 10), Vec3(-10, 10, 10), Vec3(10, -10, -10)}) {
    const Vec3 normal = surfaceNormalAt(mesh, *closestPoint(mesh, corner));
    EXPECT_LT(glm::distance(normal, glm::normalize(corner)), 1e-12);
  }
}

TEST(SurfaceNormalAt, IsTheFacetNormalIfAllCancelOut) {
  // Two boxes touch in a face, so the normals on it are opposite.
  const Mesh mesh = shapes::together(shapes::box({2, 2, 2}), shapes::translated(shapes::box({2, 2, 2}), {0, 0, 2}));
  const auto point = closestPoint(mesh, {0.2, 0.1, 1});
  EXPECT_EQ(surfaceNormalAt(mesh, *point), triangleNormal(mesh, point->triangle));
}

}  // namespace
}  // namespace qrelief
