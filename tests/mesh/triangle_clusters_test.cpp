// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_clusters.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "base/random.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

TEST(TriangleClusters, HoldEveryTriangleOnceWithinItsBox) {
  const Mesh mesh = shapes::bumpySphere(50, 3, 5, 6);
  ClusteredTriangles clustered = clusterTriangles(mesh);
  EXPECT_GT(clustered.clusters.size(), 50u);
  std::uint32_t next = 0;
  for (const TriangleCluster& cluster : clustered.clusters) {
    EXPECT_EQ(cluster.begin, next);
    EXPECT_LT(cluster.begin, cluster.end);
    next = cluster.end;
    for (std::uint32_t t = cluster.begin; t < cluster.end; ++t) {
      EXPECT_EQ(clustered.triangles[t], mesh.triangles[clustered.origins[t]]);
      for (const std::uint32_t v : clustered.triangles[t]) {
        const Vec3 p(mesh.positions[v]);
        EXPECT_TRUE(glm::all(glm::lessThanEqual(cluster.box.min, p)) &&
                    glm::all(glm::lessThanEqual(p, cluster.box.max)));
      }
    }
  }
  EXPECT_EQ(next, mesh.triangles.size());
  std::vector<Triangle> before = mesh.triangles;
  std::sort(before.begin(), before.end());
  std::sort(clustered.triangles.begin(), clustered.triangles.end());
  EXPECT_EQ(before, clustered.triangles);
}

TEST(TriangleClusters, OfASmallOrFlatMeshAreASingleOne) {
  EXPECT_EQ(clusterTriangles(shapes::box({1, 2, 3})).clusters.size(), 1u);
  EXPECT_EQ(clusterTriangles({{Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)}, {{0, 1, 2}}}).clusters.size(), 1u);
  EXPECT_TRUE(clusterTriangles({}).clusters.empty());
}

TEST(TriangleClusters, FaceAnEyeOrAwayOnlyIfAllTheirTrianglesDo) {
  Random random(11);
  int facing = 0, away = 0;
  for (const Mesh& mesh : {shapes::bumpySphere(50, 3, 5, 6), shapes::torus(40, 12, 160, 80)}) {
    const ClusteredTriangles clustered = clusterTriangles(mesh);
    for (int k = 0; k < 50; ++k) {
      const Vec3 eye(random.uniform(-200, 200), random.uniform(-200, 200), random.uniform(-200, 200));
      for (const TriangleCluster& cluster : clustered.clusters) {
        const bool allAway = cluster.facesAwayFrom(eye), allFace = cluster.faces(eye);
        facing += allFace;
        away += allAway;
        for (std::uint32_t i = cluster.begin; (allAway || allFace) && i < cluster.end; ++i) {
          const std::uint32_t t = clustered.origins[i];
          const bool faces = glm::dot(triangleNormal(mesh, t), eye - mesh.corner(t, 0)) > 0;
          ASSERT_EQ(faces, allFace);
        }
      }
    }
  }
  EXPECT_GT(facing, 200);
  EXPECT_GT(away, 200);
}

TEST(ViewPyramid, IntersectsEveryBoxWithAPointInTheSquaresView) {
  Random random(5);
  const auto anywhere = [&](double reach) {
    return Vec3(random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach));
  };
  int met = 0, left = 0;
  for (int k = 0; k < 20000; ++k) {
    const ProjectionFrame frame = makeFrame(anywhere(50), anywhere(1), {0, 1, 0}, 120);
    const ViewPyramid pyramid(frame, 40);
    Box3 box;
    const Vec3 corner = anywhere(150);
    box.add(corner);
    box.add(corner + anywhere(30));
    const Vec3 inside = glm::mix(box.min, box.max, Vec3(random.uniform(), random.uniform(), random.uniform()));
    const bool inFront = frame.distanceAlongAxis(inside) > 0;
    const Vec2 p = inFront ? glm::abs(frame.project(inside)) : Vec2(0);
    if (inFront && p.x <= 20 && p.y <= 20) {
      EXPECT_TRUE(pyramid.mayMeet(box));
      ++met;
    } else {
      left += pyramid.mayMeet(box) ? 0 : 1;
    }
  }
  EXPECT_GT(met, 200);
  EXPECT_GT(left, 15000);  // most boxes lie elsewhere, and the pyramid excludes most of them
}

TEST(ViewPyramid, OmitsBoxesBehindTheEye) {
  const ViewPyramid pyramid(makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 100), 40);
  EXPECT_FALSE(pyramid.mayMeet({{-0.1, -0.1, 101}, {0.1, 0.1, 110}}));
  EXPECT_TRUE(pyramid.mayMeet({{-5, -5, 90}, {5, 5, 110}}));
  EXPECT_FALSE(pyramid.mayMeet({{30, -5, -1}, {40, 5, 1}}));
}

}  // namespace
}  // namespace qrelief
