// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/crossings.h"

#include <gtest/gtest.h>

#include "projection/size.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// Returns the triangle of the first box's upper face, a square of 40 mm at z = 5, under a point.
std::uint32_t topTriangle(const Mesh& mesh, Vec2 at) {
  for (std::uint32_t t = 0; t < 12; ++t) {
    Triangle2 flat;
    bool top = true;
    for (int k = 0; k < 3; ++k) {
      const Vec3 corner = mesh.corner(t, k);
      top = top && corner.z == 5;
      flat[static_cast<std::size_t>(k)] = Vec2(corner.x, corner.y);
    }
    if (top && distanceToTriangle(at, flat) == 0) return t;
  }
  return kNone;
}

double sizeAt(const Mesh& mesh, bool withCrossings) {
  const ProjectionFrame frame = makeFrame({0, 1, 5}, {0, 0, 1}, {0, 1, 0}, 250);
  auto patch = findSilhouette(mesh, buildAdjacency(mesh.triangles), frame, topTriangle(mesh, {0, 1}), 100);
  EXPECT_TRUE(patch.has_value());
  if (withCrossings) {
    EXPECT_TRUE(addCrossings(mesh, frame, *patch).has_value());
  }
  return orientedSize(patch->silhouette);
}

TEST(Crossings, BoundACodeWhereAnotherBodyPiercesTheFace) {
  // The column's upper edges are contour edges. From the eye they appear farther out than where the column comes
  // through.
  const Mesh mesh =
      shapes::together(shapes::box({40, 40, 10}), shapes::translated(shapes::box({4, 60, 30}), {10, 0, 0}));
  EXPECT_NEAR(sizeAt(mesh, true), 16, 1e-9);
}

TEST(Crossings, OfASlopeThatRisesFromTheFaceAreNoContour) {
  // A ramp comes out of the face along x = 6 and faces the eye all the way, so no contour edge marks its start.
  Mesh ramp = shapes::plate({20, 60}, 20, 1, 1, [](double x, double) { return x; });
  const Mesh mesh = shapes::together(shapes::box({40, 40, 10}), shapes::translated(ramp, {6, 0, 5}));
  EXPECT_GT(sizeAt(mesh, false), 12.1);
  EXPECT_NEAR(sizeAt(mesh, true), 12, 1e-9);
}

TEST(Crossings, OfBodiesThatTouchAtAPointAreThatPoint) {
  // The tip of a spike touches the face from inside. The spike's own sides come nearer to the centre than its tip.
  Mesh tip = shapes::box({4, 4, 4});
  for (Vec3f& p : tip.positions)
    p = p.x == p.y && p.y == p.z && p.x > 0 ? Vec3f(9, -3, 5) : p * 0.25f + Vec3f(9, -3, 0);
  const Mesh mesh = shapes::together(shapes::box({40, 40, 10}), tip);
  EXPECT_NEAR(sizeAt(mesh, true), 18, 1e-9);
}

TEST(Crossings, BoundACodeWhereAnotherBodyStandsOnTheFace) {
  // The face's diagonal, which passes near the centre, is no limit.
  const Mesh mesh =
      shapes::together(shapes::box({40, 40, 10}), shapes::translated(shapes::box({4, 60, 6}), {12, 0, 8}));
  EXPECT_NEAR(sizeAt(mesh, true), 20, 1e-9);
}

TEST(Crossings, LeaveNoRoomWhereTheFaceOfAnotherBodyLiesInTheSamePlace) {
  const Mesh mesh = shapes::together(shapes::box({40, 40, 10}), shapes::box({40, 40, 10}));
  EXPECT_LT(sizeAt(mesh, true), 2);
}

TEST(Crossings, OfABodyInlaidFlushAreItsOutline) {
  // Its upper face lies in the plane of the face. The face's own diagonal, which passes near the centre, is no limit.
  const Mesh mesh =
      shapes::together(shapes::box({40, 40, 10}), shapes::translated(shapes::box({4, 20, 4}), {12, 0, 3}));
  EXPECT_NEAR(sizeAt(mesh, true), 20, 1e-6);
}

TEST(Crossings, AreFoundNearestFirst) {
  // The column comes through the face along x = 8 to 12, all the way from y = -20 to 20.
  const Mesh mesh =
      shapes::together(shapes::box({40, 40, 10}), shapes::translated(shapes::box({4, 60, 30}), {10, 0, 0}));
  const ProjectionFrame frame = makeFrame({0, 1, 5}, {0, 0, 1}, {0, 1, 0}, 250);
  const auto patch = findSilhouette(mesh, buildAdjacency(mesh.triangles), frame, topTriangle(mesh, {0, 1}), 100);
  ASSERT_TRUE(patch.has_value());
  const auto crossing = nearestCrossing(mesh, patch->triangles, {0, 1, 5});
  ASSERT_TRUE(crossing.has_value() && crossing->has_value());
  EXPECT_NEAR(glm::distance(**crossing, Vec3(8, 1, 5)), 0, 1e-9);
}

TEST(Crossings, AreFoundWhereTheyAreIfTheyOnlyTouchAFacet) {
  // A corner of the post lies on the face's diagonal, so that its walls meet the other half of the face in a point
  // only.
  const Mesh mesh = shapes::together(shapes::box({40, 40, 10}), shapes::box({6, 6, 30}));
  const ProjectionFrame frame = makeFrame({10, 10, 5}, {0, 0, 1}, {0, 1, 0}, 250);
  const auto patch = findSilhouette(mesh, buildAdjacency(mesh.triangles), frame, topTriangle(mesh, {10, 10}), 100);
  ASSERT_TRUE(patch.has_value());
  for (const Vec3 at : {Vec3(10, 10, 5), Vec3(-10, 10, 5), Vec3(10, -10, 5), Vec3(-10, -10, 5)}) {
    const auto crossing = nearestCrossing(mesh, patch->triangles, at);
    ASSERT_TRUE(crossing.has_value() && crossing->has_value());
    EXPECT_NEAR(glm::distance(**crossing, Vec3(at.x * 0.3, at.y * 0.3, 5)), 0, 1e-9);
  }
}

TEST(Crossings, AreNotFoundInAnIntactSurface) {
  const Mesh box = shapes::box({40, 40, 10});
  const std::vector<std::uint32_t> all{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  const auto crossing = nearestCrossing(box, all, {0, 1, 5});
  ASSERT_TRUE(crossing.has_value());
  EXPECT_FALSE(crossing->has_value());
}

TEST(Crossings, KeepAnIntactSurfaceUnchanged) {
  const Mesh box = shapes::box({40, 40, 10});
  EXPECT_EQ(sizeAt(box, true), sizeAt(box, false));
}

}  // namespace
}  // namespace qrelief
