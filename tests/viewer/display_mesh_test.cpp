// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/display_mesh.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

TEST(DisplayMesh, ABoxHasThreeVerticesPerCornerWithTheNormalsOfTheFaces) {
  const Mesh box = shapes::box({20, 30, 40});
  const DisplayMesh display = splitAtCreases(box);
  EXPECT_EQ(display.mesh.positions.size(), 24u);
  ASSERT_EQ(display.mesh.triangles.size(), box.triangles.size());
  for (std::size_t t = 0; t < box.triangles.size(); ++t) {
    const Vec3 facet = triangleNormal(box, t);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(display.mesh.corner(t, k), box.corner(t, k));
      EXPECT_LT(glm::length(Vec3(display.normals[display.mesh.triangles[t][k]]) - facet), 1e-6);
    }
  }
}

TEST(DisplayMesh, AFineSphereStaysWholeWithRadialNormals) {
  const Mesh sphere = shapes::icosphere(30, 4);
  const DisplayMesh display = splitAtCreases(sphere);
  ASSERT_EQ(display.mesh.positions.size(), sphere.positions.size());
  for (std::size_t v = 0; v < display.normals.size(); ++v)
    EXPECT_LT(glm::length(display.normals[v] - glm::normalize(display.mesh.positions[v])), 0.01f);
}

TEST(DisplayMesh, ACylinderIsSmoothAroundAndSharpAtItsRims) {
  const DisplayMesh display = splitAtCreases(shapes::cylinder(10, 20, 36));
  // Rim vertices count once for the side and once for the cap, the caps' middles once.
  EXPECT_EQ(display.mesh.positions.size(), 2u * 72 + 2);
}

TEST(DisplayMesh, TheTipOfAFanOfManyFacetsTakesLinearTime) {
  const Mesh cylinder = shapes::cylinder(10, 20, 200'000);
  const DisplayMesh display = splitAtCreases(cylinder);
  EXPECT_EQ(display.mesh.triangles.size(), cylinder.triangles.size());
}

TEST(DisplayMesh, ACarvedSurfaceHasSmoothNormalsExceptItsWalls) {
  DisplayMesh plate = splitAtCreases(shapes::box({20, 20, 10}));
  const ProjectionFrame frame = makeFrame({0, 0, 5}, {0, 0, 1}, {0, 1, 0}, 250);
  const MapWindow window{30, 8};
  const Vec3 tilted = glm::normalize(Vec3(0.2, 0, 1));
  std::vector<float> smooth;
  for (int texel = 0; texel < 64; ++texel)
    for (const double value : {tilted.x, tilted.y, tilted.z, 0.0}) smooth.push_back(static_cast<float>(value));
  const DisplayMesh before = plate;
  takeSmoothNormals(plate, 0, frame, window, smooth);
  int changed = 0;
  for (std::size_t v = 0; v < plate.normals.size(); ++v) {
    const bool isTop = before.normals[v].z > 0.9f;
    EXPECT_LT(glm::length(Vec3(plate.normals[v]) - (isTop ? tilted : Vec3(before.normals[v]))), 1e-6);
    changed += isTop;
  }
  EXPECT_EQ(changed, 4);
}

}  // namespace
}  // namespace qrelief
