// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flat_region.h"

#include <cmath>
#include <gtest/gtest.h>

#include "math/angle.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

Vec3 regionNormal(const Mesh& mesh, std::uint32_t triangle) {
  return flatRegionNormal(mesh, buildAdjacency(mesh.triangles), triangle);
}

TEST(FlatRegion, ABoxsFaceEndsAtItsEdges) {
  const Mesh box = shapes::box({30, 20, 10});
  for (std::uint32_t t = 0; t < box.triangles.size(); ++t) {
    const Vec3 normal = regionNormal(box, t);
    EXPECT_NEAR(glm::distance(normal, triangleNormal(box, t)), 0, 1e-12);
  }
}

TEST(FlatRegion, AWavyFaceCountsAsFlatByItsMean) {
  // Waves of 1° in x: the slopes of one triangle differ from the plane's, the mean over whole waves does not.
  const double slope = std::tan(toRadians(1));
  const Mesh wavy = shapes::plate({40, 40}, 5, 40, 4, [&](double x, double) {
    const double at = std::abs(std::remainder(x, 4.0));
    return slope * at;
  });
  const std::uint32_t seed = [&] {
    for (std::uint32_t t = 0; t < wavy.triangles.size(); ++t)
      if (triangleNormal(wavy, t).z > 0.9) return t;
    return 0u;
  }();
  ASSERT_GT(std::abs(triangleNormal(wavy, seed).x), 0.017);
  EXPECT_NEAR(glm::distance(regionNormal(wavy, seed), Vec3(0, 0, 1)), 0, 1e-6);
}

TEST(FlatRegion, OnASphereTheNormalIsTheOneThere) {
  const Mesh sphere = shapes::icosphere(20, 5);
  for (const std::uint32_t t : {0u, 777u, 5000u})
    EXPECT_LT(glm::distance(regionNormal(sphere, t), triangleNormal(sphere, t)), std::sin(toRadians(2)));
}

}  // namespace
}  // namespace qrelief
