// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace qrelief {
namespace {

double longestEdge(const Mesh& mesh) {
  double longest = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, glm::distance(mesh.corner(t, k), mesh.corner(t, (k + 1) % 3)));
  return longest;
}

TEST(RefineEdges, SplitsABoxIntoShortEdgesWithoutTJunctionsAndKeepsItsVolume) {
  const Mesh box = shapes::box({40, 20, 10});
  const Mesh fine = refineEdges(box, 3, 100000);
  EXPECT_LE(longestEdge(fine), 3);
  EXPECT_TRUE(shapes::isClosed(fine));
  EXPECT_NEAR(signedVolume(fine), 40 * 20 * 10, 1e-6 * 8000);
  EXPECT_TRUE(std::equal(box.positions.begin(), box.positions.end(), fine.positions.begin()));
}

TEST(RefineEdges, SplitsSliversAlongTheirLengthOnly) {
  const Mesh cylinder = shapes::cylinder(30, 120, 96);  // strips of 2 × 120 mm
  const Mesh fine = refineEdges(cylinder, 8, 100000);
  EXPECT_LE(longestEdge(fine), 8);
  EXPECT_TRUE(shapes::isClosed(fine));
  EXPECT_NEAR(signedVolume(fine), signedVolume(cylinder), 1e-6 * signedVolume(cylinder));
  const auto onRim = [](const Vec3f& p) { return std::abs(p.z) == 60 && std::hypot(p.x, p.y) > 29.9; };
  EXPECT_EQ(std::count_if(fine.positions.begin(), fine.positions.end(), onRim), 2 * 96);
}

TEST(RefineEdges, KeepsAMeshWithShortEdgesUnchanged) {
  const Mesh sphere = shapes::icosphere(10, 3);
  const Mesh same = refineEdges(sphere, 5, 100000);
  EXPECT_EQ(same.triangles, sphere.triangles);
}

TEST(RefineEdges, StopsBeforeTheMaximumNumberOfTriangles) {
  const Mesh some = refineEdges(shapes::box({40, 20, 10}), 0.01, 1000);
  EXPECT_LE(some.triangles.size(), 1000u);
  EXPECT_GT(some.triangles.size(), 12u);
  EXPECT_TRUE(shapes::isClosed(some));
}

}  // namespace
}  // namespace qrelief
