// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewer/two_values.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

/// Returns the area of the triangles whose vertices all have this value, mm².
double areaOf(const TwoValues& two, float value) {
  double area = 0;
  const Mesh& mesh = two.display.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    for (const std::uint32_t corner : corners) EXPECT_EQ(two.values[corner], two.values[corners[0]]);
    if (two.values[corners[0]] != value) continue;
    area += glm::length(glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0))) / 2;
  }
  return area;
}

TEST(TwoValues, CutsTrianglesWhereTheValuesEqualTheThreshold) {
  const DisplayMesh display = splitAtCreases(shapes::box({20, 20, 20}));
  std::vector<float> heights;
  for (const Vec3f& position : display.mesh.positions) heights.push_back(position.z);
  const TwoValues two = twoValues(display, heights, 5);  // of -10 … 10
  EXPECT_NEAR(areaOf(two, 1), 400 + 4 * 20 * 5, 1e-3);
  EXPECT_NEAR(areaOf(two, 0), 400 + 4 * 20 * 15, 1e-3);
  EXPECT_EQ(two.values.size(), two.display.mesh.positions.size());
  ASSERT_EQ(two.display.normals.size(), two.display.mesh.positions.size());
  for (std::size_t t = 0; t < two.display.mesh.triangles.size(); ++t)
    for (const std::uint32_t corner : two.display.mesh.triangles[t])
      EXPECT_LT(glm::length(Vec3(two.display.normals[corner]) - triangleNormal(two.display.mesh, t)), 1e-5);
}

TEST(TwoValues, LeavesAMeshOnOneSideAsItIs) {
  const DisplayMesh display = splitAtCreases(shapes::icosphere(10, 2));
  const std::vector<float> values(display.mesh.positions.size(), 3);
  for (const float threshold : {3.0f, 4.0f}) {
    const TwoValues two = twoValues(display, values, threshold);
    EXPECT_EQ(two.display.mesh.triangles, display.mesh.triangles);
    EXPECT_EQ(two.display.mesh.positions, display.mesh.positions);
    EXPECT_EQ(two.values, std::vector<float>(values.size(), threshold == 3 ? 1.0f : 0.0f));
  }
}

}  // namespace
}  // namespace qrelief
