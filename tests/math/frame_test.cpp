// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/frame.h"

#include <cmath>
#include <gtest/gtest.h>

#include "math/angle.h"

namespace qrelief {
namespace {

void expectNear(Vec3 a, Vec3 b, double tolerance = 1e-12) { EXPECT_LT(glm::distance(a, b), tolerance); }

void expectOrthonormal(const ProjectionFrame& frame) {
  expectNear(glm::cross(frame.right, frame.up), frame.normal);
  EXPECT_NEAR(glm::length(frame.right), 1, 1e-12);
  EXPECT_NEAR(glm::length(frame.up), 1, 1e-12);
  EXPECT_NEAR(glm::dot(frame.right, frame.up), 0, 1e-12);
}

TEST(MakeFrame, IsOrthonormalAndRightHandedForAnyNormal) {
  for (const Vec3 normal : {Vec3(1, 0, 0), Vec3(0, 0, -3), Vec3(1, 2, -3), Vec3(1e-9, 1, 0)})
    for (const Vec3 up : {Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(0), Vec3(5, -1, 2)})
      expectOrthonormal(makeFrame({1, 2, 3}, normal, up, 250));
}

TEST(MakeFrame, TurnsUpAsNearToTheHintAsThePlaneAllows) {
  expectNear(makeFrame({0, 0, 0}, {1, 0, 0}, {7, 0, 2}, 250).up, {0, 0, 1});
}

TEST(MakeFrame, UsesYIfTheHintIsParallelToTheNormal) {
  expectNear(makeFrame({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, 250).up, {0, 1, 0});
  expectNear(makeFrame({0, 0, 0}, {0, 0, -2}, {0, 0, 1}, 250).up, {0, 1, 0});
}

TEST(MakeFrame, UsesXIfHintAndYAreParallelToTheNormal) {
  expectNear(makeFrame({0, 0, 0}, {0, 1, 0}, {0, -1, 0}, 250).up, {1, 0, 0});
}

TEST(ProjectionFrame, ProjectsEveryPointOfARayToItsPlanePoint) {
  const ProjectionFrame frame = makeFrame({10, -20, 5}, {1, 2, 2}, {0, 0, 1}, 250);
  for (const Vec2 p : {Vec2(0, 0), Vec2(17, -4), Vec2(-30, 25)}) {
    for (const double t : {1.0, 200.0, 400.0}) {
      const Vec2 q = frame.project(frame.eye() + frame.rayDirection(p) * t);
      EXPECT_NEAR(q.x, p.x, 1e-10);
      EXPECT_NEAR(q.y, p.y, 1e-10);
    }
    const Vec2 onPlane = frame.project(frame.onPlane(p));
    EXPECT_NEAR(onPlane.x, p.x, 1e-10);
    EXPECT_NEAR(onPlane.y, p.y, 1e-10);
  }
}

TEST(ProjectionFrame, MeasuresDepthBelowTheEyeAlongTheAxis) {
  const ProjectionFrame frame = makeFrame({1, 1, 1}, {0, 0, 1}, {0, 1, 0}, 250);
  EXPECT_DOUBLE_EQ(frame.distanceAlongAxis({7, -3, 1}), 250);
  EXPECT_DOUBLE_EQ(frame.distanceAlongAxis({0, 0, -9}), 260);
}

TEST(ProjectionFrame, TurnsAnticlockwiseAboutItsNormal) {
  const ProjectionFrame frame = makeFrame({1, 2, 3}, {0, 0, 1}, {0, 1, 0}, 100);
  const ProjectionFrame sixth = turned(frame, toRadians(60));
  expectNear(sixth.right, {0.5, std::sqrt(0.75), 0});
  expectNear(sixth.up, {-std::sqrt(0.75), 0.5, 0});
  expectNear(sixth.normal, frame.normal);
  expectNear(sixth.centre, frame.centre);
  EXPECT_EQ(toDegrees(toRadians(180)), 180);
}

TEST(ProjectionFrame, ShrinksWhatLiesFartherAway) {
  const ProjectionFrame frame = makeFrame({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 100);
  EXPECT_NEAR(frame.project({10, 0, -100}).x, 5, 1e-12);
}

}  // namespace
}  // namespace qrelief
