// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/crossing_segments.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "mesh/ray.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

Mesh trianglesOf(const std::vector<Vec3f>& corners) {
  Mesh mesh;
  mesh.positions = corners;
  for (std::uint32_t t = 0; 3 * t < corners.size(); ++t) mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  return mesh;
}

double distanceFrom(const Mesh& mesh, std::uint32_t triangle, Vec3 point) {
  Mesh one = mesh;
  one.triangles = {mesh.triangles[triangle]};
  return glm::distance(closestPoint(one, point)->position, point);
}

TEST(CrossingSegments, EndInBothTrianglesWhereverTheyCross) {
  Random random(7);
  int crossing = 0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<Vec3f> corners;
    for (int c = 0; c < 6; ++c) {
      // Few coordinates, so that many triangles touch at corners, sides or in a plane.
      const auto coordinate = [&] { return static_cast<float>(random.below(5)); };
      const float x = coordinate(), y = coordinate(), z = coordinate();
      corners.push_back({x, y, z});
    }
    const Mesh mesh = trianglesOf(corners);
    const auto pairs = findCrossings(mesh);
    ASSERT_TRUE(pairs.has_value());
    if (pairs->empty()) continue;
    ++crossing;
    const std::vector<Segment3> segments = crossingSegments(mesh, 0, 1);
    ASSERT_FALSE(segments.empty());
    for (const Segment3& segment : segments)
      for (const Vec3 end : segment)
        for (const std::uint32_t t : {0u, 1u}) EXPECT_LT(distanceFrom(mesh, t, end), 1e-6) << k;
  }
  EXPECT_GT(crossing, 200);
}

TEST(CrossingSegments, AreTheWholeLineThatTwoTrianglesShare) {
  const Mesh mesh = trianglesOf({{0, 0, 0}, {60, 0, 0}, {0, 60, 0}, {10, 10, -5}, {10, 30, -5}, {10, 10, 5}});
  const std::vector<Segment3> segments = crossingSegments(mesh, 0, 1);
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_NEAR(glm::distance(segments[0][0], segments[0][1]), 10, 1e-12);  // from (10, 10, 0) to (10, 20, 0)
  EXPECT_NEAR(glm::distance(crossingPoint(mesh, {0, 1}), Vec3(10, 15, 0)), 0, 1e-12);
}

TEST(CrossingSegments, OfTrianglesThatMeetInAPointAreThatPoint) {
  // The upright side of the second passes through the long side of the first; its rest is beyond.
  const Mesh mesh = trianglesOf({{0, 0, 0}, {60, 60, 0}, {0, 60, 0}, {5, 5, -5}, {5, 5, 5}, {9, 5, -5}});
  ASSERT_EQ(findCrossings(mesh)->size(), 1u);
  for (const Segment3& segment : crossingSegments(mesh, 0, 1))
    for (const Vec3 end : segment) EXPECT_NEAR(glm::distance(end, Vec3(5, 5, 0)), 0, 1e-9);
}

}  // namespace
}  // namespace qrelief
