// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "base/random.h"
#include "messages/sentences.h"
#include "projection/size.h"
#include "support/brute_force.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

using testing::HasSubstr;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kRoot2 = std::numbers::sqrt2;

Result<VisiblePatch> patchAt(const Mesh& mesh, const brute_force::Spot& spot, double radius = kInfinite,
                             GrowingRegion region = GrowingRegion::Disc) {
  return findSilhouette(mesh, buildAdjacency(mesh.triangles), spot.frame, spot.seed, radius, region);
}

/// Looks straight from above at the surface point over (x, y).
brute_force::Spot fromAbove(const Mesh& mesh, double x, double y, Vec3 up = {0, 1, 0}, double eyeDistance = 250) {
  return brute_force::spotSeen(mesh, {x, y, 500}, {0, 0, -1}, {0, 0, 1}, up, eyeDistance);
}

/// Expects that the eye sees nothing but the patch in the disc and in the aligned square that the silhouette allows.
void expectSeenWithin(const Mesh& mesh, const ProjectionFrame& frame, const VisiblePatch& patch, int samples = 400) {
  std::vector<std::uint8_t> inPatch(mesh.triangles.size(), 0);
  for (const std::uint32_t t : patch.triangles) inPatch[t] = 1;
  const double most = kRoot2 * patch.radiusMm;
  const double radius = std::min(freeSize(patch.silhouette), most) / kRoot2 * (1 - 1e-9);
  const double half = std::min(orientedSize(patch.silhouette), most) / 2 * (1 - 1e-9);
  Random random(17);
  for (int k = 0; k < samples; ++k) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    const Vec2 onDisc = Vec2(std::cos(angle), std::sin(angle)) * (radius * std::sqrt(random.uniform()));
    const Vec2 onSquare(random.uniform(-half, half), random.uniform(-half, half));
    for (const Vec2 p : {onDisc, onSquare}) {
      const brute_force::Hit hit = brute_force::castRay(mesh, frame.eye(), frame.rayDirection(p));
      ASSERT_NE(hit.triangle, kNoTriangle) << "at " << p.x << ", " << p.y;
      ASSERT_TRUE(inPatch[hit.triangle]) << "triangle " << hit.triangle << " at " << p.x << ", " << p.y;
    }
  }
}

/// Expects that the images of the patch's facets do not overlap: no sample point of one lies inside another.
void expectNoOverlap(const Mesh& mesh, const ProjectionFrame& frame, const VisiblePatch& patch) {
  std::vector<Triangle2> images;
  for (const std::uint32_t t : patch.triangles)
    images.push_back(
        {frame.project(mesh.corner(t, 0)), frame.project(mesh.corner(t, 1)), frame.project(mesh.corner(t, 2))});
  const auto wellInside = [](Vec2 p, const Triangle2& t) {
    for (std::size_t k = 0; k < 3; ++k)
      if (cross2(t[(k + 1) % 3] - t[k], p - t[k]) < 1e-9) return false;
    return true;
  };
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Triangle2& t = images[i];
    for (const Vec3 weight : {Vec3(1, 1, 1), Vec3(8, 1, 1), Vec3(1, 8, 1), Vec3(1, 1, 8)}) {
      const Vec2 p = (t[0] * weight.x + t[1] * weight.y + t[2] * weight.z) / (weight.x + weight.y + weight.z);
      for (std::size_t j = 0; j < images.size(); ++j)
        ASSERT_FALSE(i != j && wellInside(p, images[j])) << patch.triangles[i] << " and " << patch.triangles[j];
    }
  }
}

/// Expects that every facet can be reached from the seed over facets of the patch.
void expectConnected(const Mesh& mesh, std::uint32_t seed, const VisiblePatch& patch) {
  const Adjacency adjacency = buildAdjacency(mesh.triangles);
  std::vector<std::uint8_t> unreached(mesh.triangles.size(), 0);
  for (const std::uint32_t t : patch.triangles) unreached[t] = 1;
  std::vector<std::uint32_t> stack{seed};
  std::size_t reached = 0;
  while (!stack.empty()) {
    const std::uint32_t t = stack.back();
    stack.pop_back();
    if (t == kNoTriangle || !unreached[t]) continue;
    unreached[t] = 0;
    ++reached;
    stack.insert(stack.end(), adjacency[t].begin(), adjacency[t].end());
  }
  EXPECT_EQ(reached, patch.triangles.size());
}

/// Expects that the silhouette's nearest point lies on the image of an edge where the surface turns away from the eye.
void expectEndsForAReason(const Mesh& mesh, const ProjectionFrame& frame, const VisiblePatch& patch) {
  const Vec2 s = nearestSilhouettePoint(patch.silhouette).value();
  const Adjacency adjacency = buildAdjacency(mesh.triangles);
  const auto faces = [&](std::uint32_t t) {
    return glm::dot(triangleNormal(mesh, t), frame.eye() - mesh.corner(t, 0)) > 0;
  };
  double nearest = kInfinite;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (faces(t) && !faces(adjacency[t][static_cast<std::size_t>(k)]))
        nearest = std::min(nearest, distanceToSegment(s, {frame.project(mesh.corner(t, k)),
                                                          frame.project(mesh.corner(t, (k + 1) % 3))}));
  EXPECT_LT(nearest, 1e-9) << "at " << s.x << ", " << s.y;
}

TEST(Silhouette, OfACubesFaceIsThatFace) {
  const Mesh mesh = shapes::box({40, 40, 40});
  const brute_force::Spot spot = fromAbove(mesh, 0, 0);
  const Result<VisiblePatch> patch = patchAt(mesh, spot);
  ASSERT_TRUE(patch);
  EXPECT_EQ(patch->triangles.size(), 2u);
  EXPECT_EQ(patch->silhouette.size(), 4u);
  EXPECT_DOUBLE_EQ(freeSize(patch->silhouette), 20 * kRoot2);
  EXPECT_DOUBLE_EQ(orientedSize(patch->silhouette), 40);
}

TEST(Silhouette, OfACubesFaceTurnedBy45DegreesFitsASmallerAlignedSquare) {
  const Mesh mesh = shapes::box({40, 40, 40});
  const Result<VisiblePatch> patch = patchAt(mesh, fromAbove(mesh, 0, 0, {1, 1, 0}));
  ASSERT_TRUE(patch);
  EXPECT_NEAR(freeSize(patch->silhouette), 20 * kRoot2, 1e-12);
  EXPECT_NEAR(orientedSize(patch->silhouette), 20 * kRoot2, 1e-12);
}

TEST(Silhouette, GoesOverTheEdgesOfACubeSeenFromItsCorner) {
  // The eye sees three faces. In perspective the plane cuts off less than the hexagonal outline's inner circle.
  const Mesh mesh = shapes::box({40, 40, 40});
  const brute_force::Spot spot = brute_force::spotSeen(mesh, {100, 100, 100}, {-1, -1, -1}, {1, 1, 1}, {0, 0, 1});
  const Result<VisiblePatch> patch = patchAt(mesh, spot);
  ASSERT_TRUE(patch);
  EXPECT_EQ(patch->triangles.size(), 6u);
  EXPECT_EQ(patch->silhouette.size(), 6u);
  // The six outline edges join corners such as (20, 20, -20) and (20, -20, -20). The middles and ends of their images
  // differ in depth, so the closed form is the origin's distance from the line through the two images.
  const auto image = [&](Vec3 p) { return spot.frame.project(p); };
  const Vec2 a = image({20, 20, -20});
  const Vec2 b = image({20, -20, -20});
  EXPECT_NEAR(freeSize(patch->silhouette), kRoot2 * std::abs(cross2(a, b)) / glm::distance(a, b), 1e-12);
}

TEST(Silhouette, OfASphereEndsAtTheTangentCone) {
  const double radius = 40;
  const Mesh mesh = shapes::icosphere(radius, 5);
  for (const Vec3 direction : {Vec3(0, 0, 1), Vec3(1, -2, 0.5)}) {
    const Vec3 normal = glm::normalize(direction);
    const brute_force::Spot spot = brute_force::spotSeen(mesh, normal * 100.0, -normal, normal, {0, 1, 0.3});
    const Result<VisiblePatch> patch = patchAt(mesh, spot);
    ASSERT_TRUE(patch);
    // The polyhedron lies between its circumscribed sphere and the sphere that its facets touch.
    double inner = radius;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      inner = std::min(inner, glm::dot(triangleNormal(mesh, t), mesh.corner(t, 0)));
    const double eyeToCentre = glm::length(spot.frame.eye());
    const auto tangentRadius = [&](double r) { return 250 * r / std::sqrt(eyeToCentre * eyeToCentre - r * r); };
    EXPECT_LE(freeSize(patch->silhouette), kRoot2 * tangentRadius(radius) + 1e-5);
    EXPECT_GE(freeSize(patch->silhouette), kRoot2 * tangentRadius(inner));
    EXPECT_LT(tangentRadius(radius) - tangentRadius(inner), 0.05) << "the bound is tight";
    // A convex body hides no part of itself: the patch is every facet that faces the eye, and the silhouette is the
    // patch's border.
    std::size_t facing = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      facing += glm::dot(triangleNormal(mesh, t), spot.frame.eye() - mesh.corner(t, 0)) > 0;
    EXPECT_EQ(patch->triangles.size(), facing);
    expectSeenWithin(mesh, spot.frame, *patch, 50);
  }
}

/// Returns a floor at z = 0 and a box above it that does not touch it, so that the floor is partly hidden.
Mesh floorUnder(Vec3 boxSize, Vec3 boxCentre, int grid) {
  return shapes::together(shapes::plate({120, 120}, 10, grid, grid),
                          shapes::translated(shapes::box(boxSize), boxCentre));
}

TEST(Silhouette, EndsAtTheEdgeOfAnOccluderAboveIt) {
  // The box covers 20 ≤ x ≤ 40, 10 ≤ z ≤ 20. Its lower edge at x = 20 hides the most: 20·250/240 on the plane.
  for (const int grid : {1, 3, 24}) {
    const Mesh mesh = floorUnder({20, 20, 10}, {30, 0, 15}, grid);
    const brute_force::Spot spot = fromAbove(mesh, 0, 0);
    const Result<VisiblePatch> patch = patchAt(mesh, spot);
    ASSERT_TRUE(patch);
    const double reach = 20 * 250.0 / 240;
    EXPECT_NEAR(freeSize(patch->silhouette), kRoot2 * reach, 1e-12) << grid << " squares";
    EXPECT_NEAR(orientedSize(patch->silhouette), 2 * reach, 1e-12) << grid << " squares";
    expectSeenWithin(mesh, spot.frame, *patch);
    expectNoOverlap(mesh, spot.frame, *patch);
    for (const std::uint32_t t : patch->triangles) EXPECT_EQ(mesh.corner(t, 0).z, 0) << "the box is not connected";
  }
}

TEST(Silhouette, EndsWhereAnOccludersEdgeCoincidesWithItsOwn) {
  // The lower edge at x = 10, z = 125 appears at x = 20, exactly on a line of the floor's grid.
  const Mesh mesh = floorUnder({20, 20, 10}, {20, 0, 130}, 6);
  const brute_force::Spot spot = fromAbove(mesh, 0, 0);
  const Result<VisiblePatch> patch = patchAt(mesh, spot);
  ASSERT_TRUE(patch);
  EXPECT_DOUBLE_EQ(freeSize(patch->silhouette), 20 * kRoot2);
  EXPECT_DOUBLE_EQ(orientedSize(patch->silhouette), 40);
  expectSeenWithin(mesh, spot.frame, *patch);
}

TEST(Silhouette, PassesBetweenTwoOccluders) {
  // There is a gap of 10 mm between two boxes over huge facets. An aligned square may grow up to the gap, but not into
  // it.
  const Mesh boxes = shapes::together(shapes::translated(shapes::box({20, 20, 10}), {30, 15, 15}),
                                      shapes::translated(shapes::box({20, 20, 10}), {30, -15, 15}));
  const Mesh mesh = shapes::together(shapes::plate({120, 120}, 10, 1, 1), boxes);
  const brute_force::Spot spot = fromAbove(mesh, 0, 0);
  const Result<VisiblePatch> patch = patchAt(mesh, spot);
  ASSERT_TRUE(patch);
  const Vec2 corner = spot.frame.project({20, 5, 10});
  EXPECT_NEAR(freeSize(patch->silhouette), kRoot2 * glm::length(corner), 1e-12);
  EXPECT_NEAR(orientedSize(patch->silhouette), 2 * std::abs(corner.x), 1e-12);
  expectSeenWithin(mesh, spot.frame, *patch);
}

/// Returns a plate with a ridge along y at x = 20, 20 mm high, falling to both sides within 10 mm, |y| ≤ halfLength.
Mesh ridge(double halfLength, int n) {
  return shapes::plate({160, 160}, 10, n, n, [=](double x, double y) {
    return std::max(0.0, 20 - 2 * std::abs(x - 20)) * (std::abs(y) <= halfLength ? 1 : 0);
  });
}

TEST(Silhouette, EndsAtARidgeThatHidesItsOtherSide) {
  const Mesh mesh = ridge(1000, 16);
  // The view is at 45° from the left, so the ridge lies in the QR plane, at 20·√2 from the centre.
  const brute_force::Spot spot = brute_force::spotSeen(mesh, {0, 0, 50}, {0, 0, -1}, {-1, 0, 1}, {0, 1, 0});
  const Result<VisiblePatch> patch = patchAt(mesh, spot);
  ASSERT_TRUE(patch);
  EXPECT_NEAR(freeSize(patch->silhouette), 40, 1e-12);
  for (const std::uint32_t t : patch->triangles)
    for (int k = 0; k < 3; ++k) EXPECT_LE(mesh.corner(t, k).x, 20);
  expectSeenWithin(mesh, spot.frame, *patch);
}

TEST(Silhouette, GoesAroundARidgeWithoutOverlappingItself) {
  for (const int n : {16, 32}) {
    const Mesh mesh = ridge(30, n);
    for (const Vec2 centre : {Vec2(0, 0), Vec2(0.3, 44.7), Vec2(52.1, 3.9), Vec2(20.5, -55)}) {
      const brute_force::Spot spot =
          brute_force::spotSeen(mesh, {centre.x, centre.y, 50}, {0, 0, -1}, {-1, 0.2, 1}, {0, 1, 0});
      std::array<double, 2> free{}, oriented{};
      for (const GrowingRegion region : {GrowingRegion::Disc, GrowingRegion::Square}) {
        const Result<VisiblePatch> patch = patchAt(mesh, spot, kInfinite, region);
        ASSERT_TRUE(patch) << patch.error().message;
        EXPECT_TRUE(patch->partlyHidden);
        expectSeenWithin(mesh, spot.frame, *patch);
        expectNoOverlap(mesh, spot.frame, *patch);
        expectConnected(mesh, spot.seed, *patch);
        expectEndsForAReason(mesh, spot.frame, *patch);
        const auto k = static_cast<std::size_t>(region);
        free[k] = freeSize(patch->silhouette);
        oriented[k] = orientedSize(patch->silhouette);
      }
      // Each patch leaves the most room for its own kind of region.
      EXPECT_GE(free[0], free[1]);
      EXPECT_GE(oriented[1], oriented[0]);
    }
  }
}

TEST(Silhouette, OfATorusEndsAtItsInnerOcclusionContour) {
  // From 60° above the hole's axis, the near side of the ring hides part of the far side's inner wall.
  const Mesh mesh = shapes::torus(30, 12, 96, 48);
  const Vec3 normal = glm::normalize(Vec3(std::sin(1.05), 0, std::cos(1.05)));
  for (const Vec3 from : {Vec3(30, 0, 100), Vec3(-30, 1, 100), Vec3(-21, 2, 100)}) {
    const brute_force::Spot spot = brute_force::spotSeen(mesh, from, {0, 0, -1}, normal, {0, 1, 0});
    const Result<VisiblePatch> patch = patchAt(mesh, spot);
    ASSERT_TRUE(patch) << patch.error().message;
    expectSeenWithin(mesh, spot.frame, *patch, 200);
    expectNoOverlap(mesh, spot.frame, *patch);
    expectConnected(mesh, spot.seed, *patch);
    expectEndsForAReason(mesh, spot.frame, *patch);
  }
}

TEST(Silhouette, OfABumpySphereIsWhatTheEyeSees) {
  const Mesh mesh = shapes::bumpySphere(40, 4, 4, 4);
  Random random(23);
  int solved = 0;
  for (int k = 0; k < 12; ++k) {
    const Vec3 out = glm::normalize(Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    const Vec3 tilted = glm::normalize(out + Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    const brute_force::Spot spot = brute_force::spotSeen(mesh, out * 100.0, -out, tilted, {0, 0, 1}, 120);
    const Result<VisiblePatch> patch = patchAt(mesh, spot);
    if (!patch) continue;
    ++solved;
    expectSeenWithin(mesh, spot.frame, *patch, 100);
    expectNoOverlap(mesh, spot.frame, *patch);
    expectConnected(mesh, spot.seed, *patch);
  }
  EXPECT_GE(solved, 8);
}

TEST(Silhouette, OmitsFacetsBeyondTheRadiusWithoutASilhouette) {
  const Mesh mesh = shapes::plate({100, 100}, 10, 50, 50);
  const Result<VisiblePatch> patch = patchAt(mesh, fromAbove(mesh, 0.3, 0.4), 10);
  ASSERT_TRUE(patch);
  EXPECT_TRUE(patch->silhouette.empty());
  EXPECT_EQ(patch->radiusMm, 10);
  // Brute force, facet by facet, finds the squares of 2 mm that meet a disc of radius 10.
  std::vector<std::uint32_t> expected;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (triangleNormal(mesh, t).z < 0.5) continue;
    const Vec3 c(0.3, 0.4, 0);
    if (brute_force::distanceToFacet(c, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)) <= 10)
      expected.push_back(t);
  }
  EXPECT_EQ(patch->triangles, expected);
}

/// Expects the same patch whether the search looks at all facets or at the clusters about the code.
void expectSamePatchFromClusters(const Mesh& mesh, const brute_force::Spot& spot, double radius) {
  const Adjacency adjacency = buildAdjacency(mesh.triangles);
  const ClusteredTriangles clusters = clusterTriangles(mesh);
  ASSERT_GT(clusters.clusters.size(), 1u);
  for (const GrowingRegion region : {GrowingRegion::Disc, GrowingRegion::Square}) {
    const auto all = findSilhouette(mesh, adjacency, spot.frame, spot.seed, radius, region);
    const auto near = findSilhouette(mesh, adjacency, spot.frame, spot.seed, radius, region, &clusters);
    ASSERT_EQ(all.has_value(), near.has_value());
    if (!all) {
      EXPECT_EQ(sentence(all.error().message), sentence(near.error().message));
      continue;
    }
    EXPECT_EQ(all->triangles, near->triangles);
    EXPECT_EQ(all->partlyHidden, near->partlyHidden);
    const auto ends = [](const VisiblePatch& patch) {
      std::vector<std::array<double, 4>> sorted;
      for (const Segment2& s : patch.silhouette) sorted.push_back({s[0].x, s[0].y, s[1].x, s[1].y});
      std::sort(sorted.begin(), sorted.end());
      return sorted;
    };
    EXPECT_EQ(ends(*all), ends(*near));
  }
}

TEST(Silhouette, IsTheSameIfTheSearchLooksAtClustersAboutTheCodeOnly) {
  const std::array<Mesh, 3> meshes{shapes::bumpySphere(50, 6, 5, 6), shapes::torus(40, 12, 160, 80),
                                   // A wide roof over a fine plate: its facets reach far beyond the radius.
                                   shapes::together(shapes::plate({120, 120}, 4, 60, 60),
                                                    shapes::translated(shapes::box({400, 40, 3}), {200, 0, 30}))};
  Random random(23);
  for (const Mesh& mesh : meshes)
    for (int k = 0; k < 12; ++k) {
      const Vec3 at = (boundingBox(mesh).min + boundingBox(mesh).max) / 2.0;
      const Vec3 outwards = glm::normalize(Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.5, 1)) +
                                           Vec3(0, 0, 0.01));
      const brute_force::Spot seen = brute_force::spotSeen(mesh, at + outwards * 300.0, -outwards, outwards, {0, 1, 0});
      if (seen.seed == kNoTriangle) continue;
      // Half of the eyes are near, between parts of the model.
      const brute_force::Spot spot{makeFrame(seen.frame.centre, outwards, {0, 1, 0}, k % 2 ? 250 : 25), seen.seed};
      for (const double radius : {4.0, 15.0, 60.0}) expectSamePatchFromClusters(mesh, spot, radius);
    }
}

TEST(Silhouette, HasTheSilhouetteInsideTheRadiusOnly) {
  const Mesh mesh = shapes::box({40, 40, 40});
  EXPECT_EQ(patchAt(mesh, fromAbove(mesh, 5, 0), 14)->silhouette.size(), 0u);
  EXPECT_EQ(patchAt(mesh, fromAbove(mesh, 5, 0), 16)->silhouette.size(), 1u);
}

TEST(Silhouette, RefusesAHiddenCentreAndReportsHowNearTheEyeMustBe) {
  const Mesh mesh = floorUnder({20, 20, 10}, {0, 0, 15}, 4);
  const brute_force::Spot below = brute_force::spotSeen(mesh, {1, 2, 5}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0});
  const Result<VisiblePatch> patch = patchAt(mesh, below);
  ASSERT_FALSE(patch);
  EXPECT_EQ(patch.error().kind, ErrorKind::NoSolution);
  EXPECT_THAT(sentence(patch.error().message), HasSubstr("230 mm from the eye"));
  EXPECT_THAT(sentence(patch.error().message), HasSubstr("20 mm in front of the point"));
  EXPECT_THAT(hint(patch.error().message), HasSubstr("below 10 mm"));
}

TEST(Silhouette, RefusesASeedThatFacesAway) {
  const Mesh mesh = shapes::box({40, 40, 40});
  const brute_force::Spot bottom = brute_force::spotSeen(mesh, {1, 2, -90}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0});
  const Result<VisiblePatch> patch = patchAt(mesh, bottom);
  ASSERT_FALSE(patch);
  EXPECT_EQ(patch.error().kind, ErrorKind::NoSolution);
  EXPECT_THAT(sentence(patch.error().message), HasSubstr("faces away"));
}

TEST(Silhouette, RefusesASeedThatFacesTheEyeEdgeOn) {
  const Mesh mesh = shapes::box({40, 40, 40});
  const brute_force::Spot side = brute_force::spotSeen(mesh, {90, 2, 1}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0});
  const Result<VisiblePatch> patch = patchAt(mesh, side);
  ASSERT_FALSE(patch);
  EXPECT_THAT(sentence(patch.error().message), HasSubstr("faces away"));
}

TEST(Silhouette, OfAHollowBallReportsAnEyeInOrBehindTheOppositeWall) {
  const Mesh mesh = shapes::together(shapes::icosphere(50, 4), shapes::insideOut(shapes::icosphere(40, 4)));
  const auto onInnerWall = [&](double eyeDistance) {
    return brute_force::spotSeen(mesh, {0.1, 0.2, 0}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0}, eyeDistance);
  };
  // Inside the cavity nothing blocks the view, and everything far enough in front of the eye belongs to the patch.
  const brute_force::Spot inside = onInnerWall(60);
  const Result<VisiblePatch> patch = patchAt(mesh, inside, 60);
  ASSERT_TRUE(patch) << patch.error().message;
  EXPECT_TRUE(patch->silhouette.empty());
  expectSeenWithin(mesh, inside.frame, *patch, 100);
  // The eye is in the wall, then outside; the inner wall is about 80 mm away.
  for (const double eyeDistance : {85.0, 250.0}) {
    const Result<VisiblePatch> hidden = patchAt(mesh, onInnerWall(eyeDistance), 60);
    ASSERT_FALSE(hidden);
    EXPECT_THAT(sentence(hidden.error().message), HasSubstr("hides the chosen point"));
    EXPECT_THAT(hint(hidden.error().message), HasSubstr("below 79.9"));
  }
}

TEST(Silhouette, AcceptsACentreOnAVertexOrAnEdge) {
  const Mesh mesh = shapes::plate({100, 100}, 10, 10, 10);
  for (const Vec2 p : {Vec2(0, 0), Vec2(10, 5), Vec2(-25, -25)}) {
    const Result<VisiblePatch> patch = patchAt(mesh, fromAbove(mesh, p.x, p.y));
    ASSERT_TRUE(patch) << patch.error().message;
    EXPECT_NEAR(freeSize(patch->silhouette), kRoot2 * (50 - std::max(std::abs(p.x), std::abs(p.y))), 1e-12);
  }
}

TEST(Silhouette, IsBoundedByAHoleInTheSurface) {
  Mesh mesh = shapes::plate({100, 100}, 10, 10, 10);
  // Removes the two facets of the square 20 ≤ x ≤ 30, 0 ≤ y ≤ 10.
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    const Vec3f middle = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0f;
    return middle.z == 0 && middle.x > 20 && middle.x < 30 && middle.y > 0 && middle.y < 10;
  });
  const brute_force::Spot spot = fromAbove(mesh, 2, 3);
  const Result<VisiblePatch> patch = patchAt(mesh, spot);
  ASSERT_TRUE(patch);
  EXPECT_NEAR(freeSize(patch->silhouette), 18 * kRoot2, 1e-12);
}

/// Returns a bar with teeth along its upper edge: 100 × 15 × 20 mm, with sliver facets on both ends of the prism.
Mesh comb(int teeth) {
  const auto n = static_cast<std::uint32_t>(teeth);
  std::vector<Vec2> outline = {{0, 0}, {100, 0}};  // counter-clockwise
  for (std::uint32_t i = n; i > 0; --i) {
    outline.emplace_back(100.0 * i / n, 10);
    outline.emplace_back(100.0 * (i - 0.5) / n, 15);
  }
  outline.emplace_back(0, 10);
  const auto count = static_cast<std::uint32_t>(outline.size());
  Mesh mesh;
  for (const float z : {0.0f, 20.0f})
    for (const Vec2 p : outline) mesh.positions.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y), z);
  const auto addToEnds = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.push_back({c, b, a});
    mesh.triangles.push_back({count + a, count + b, count + c});
  };
  addToEnds(0, 1, 2);
  for (std::uint32_t base = 2; base + 2 < count; base += 2) {
    addToEnds(0, base, base + 2);
    addToEnds(base, base + 1, base + 2);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.triangles.push_back({i, next, count + next});
    mesh.triangles.push_back({i, count + next, count + i});
  }
  return mesh;
}

TEST(Silhouette, OfThousandsOfSliversBeforeThousandsOfContoursTakesLinearWork) {
  for (const int teeth : {50, 4000}) {
    const Mesh mesh = comb(teeth);
    const brute_force::Spot spot = brute_force::spotSeen(mesh, {50, -60, 140}, glm::normalize(Vec3(0, 0.5, -0.87)),
                                                         {0, -0.5, 0.87}, {0, 1, 0}, 250);
    const auto patch = patchAt(mesh, spot, 40);
    ASSERT_TRUE(patch.has_value()) << patch.error().message;
    EXPECT_LE(patch->looks, 2'000'000 + 60 * mesh.triangles.size()) << teeth << " teeth";
    expectSeenWithin(mesh, spot.frame, *patch, 100);
    expectNoOverlap(mesh, spot.frame, *patch);
  }
}

}  // namespace
}  // namespace qrelief
